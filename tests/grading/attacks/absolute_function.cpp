// attack: replaces write by an address
// ceiling: as a stub
// compiles: no
// message: defines write
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".globl write\nwrite = 0x401000");
