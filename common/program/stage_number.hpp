// The number of the stage whose program this is.
#pragma once

namespace rt {

extern const int stage_number;

}  // namespace rt
