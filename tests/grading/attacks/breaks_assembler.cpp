// attack: has an assembler's error, which names a temporary file
// ceiling: as a stub
// compiles: no
// message: temporary.s
// message without: raysteps.
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm("no_such_instruction");
