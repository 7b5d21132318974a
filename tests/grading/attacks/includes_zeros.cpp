// attack: includes /dev/zero
// ceiling: as a stub
// compiles: no
// message: /dev/zero
// stubs: intersect normal color_from_normal torch
#include "/dev/zero"
#include "steps/step03_sphere/sphere.hpp"
