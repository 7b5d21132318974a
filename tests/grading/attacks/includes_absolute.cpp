// attack: includes the reference by its absolute path
// ceiling: as a stub
// compiles: no
// message: reference/sphere.cpp
#include "steps/step03_sphere/sphere.hpp"

#include "@ROOT@/steps/step03_sphere/reference/sphere.cpp"
