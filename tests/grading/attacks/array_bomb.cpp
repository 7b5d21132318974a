// attack: an array of 8 GB that is not zero
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

long numbers[1L << 30] = {1};
