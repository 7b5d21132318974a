// Comparison of the student's picture with the reference's.
#pragma once

#include "common/course/exercise/two_programs.hpp"

namespace rt {

/// `./course compare`: writes both pictures and their difference to renders/, and shows them on a
/// terminal. Returns 0 if they agree, else 1. Throws InputError if the student's program takes
/// longer than ten seconds, and twenty times as long as the reference's.
int compare_pictures(const ComparisonRequest& contest);

}  // namespace rt
