// attack: includes the reference of stage 5
// ceiling: as a stub
// compiles: no
// stage: step05_triangle
// message: reference/triangle.cpp
#include "steps/step05_triangle/triangle.hpp"

#include "@ROOT@/steps/step05_triangle/reference/triangle.cpp"
