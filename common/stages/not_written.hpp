// The end of the message about an unwritten function, for what prints it and what looks for it.
#pragma once

namespace rt {

inline constexpr const char* not_written = " is not written yet";

}  // namespace rt
