// Compiled for each stage, by which its program differs from the others.
#include "common/program/stage_number.hpp"

namespace rt {

const int stage_number = RAYSTEPS_STAGE;

}  // namespace rt
