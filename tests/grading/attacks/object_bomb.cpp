// attack: an object of 4 GB
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".data\n.fill 4000000000, 1, 65\n.text");
