// attack: includes the reference by a relative path
// ceiling: as a stub
// compiles: no
// message: reference/sphere.cpp
#include "steps/step03_sphere/sphere.hpp"

#include "steps/step03_sphere/reference/sphere.cpp"
