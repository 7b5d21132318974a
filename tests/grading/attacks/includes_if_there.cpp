// attack: includes the reference if it is there
// ceiling: as a stub
// compiles: perhaps
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#if __has_include("@ROOT@/steps/step03_sphere/reference/sphere.cpp")
#include "@ROOT@/steps/step03_sphere/reference/sphere.cpp"
#else
#endif
