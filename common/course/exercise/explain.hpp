// The explanation of a pixel by both programs, or of a question that the suite reports as failed.
#pragma once

#include "common/course/exercise/two_programs.hpp"

namespace rt {

/// `./course explain`: prints where both explanations of the pixel "ROW,COLUMN" differ, the first
/// difference first; if it is empty, of the middle of the largest cluster of different pixels; and
/// if none differs, of the first failing question of the last check. Returns 0.
int explain_pixel(const ComparisonRequest& contest, std::string pixel);

}  // namespace rt
