// attack: includes the reference by .incbin
// ceiling: as a stub
// compiles: no
// message: reference/sphere.cpp
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".section .rodata\n.incbin \"@ROOT@/steps/step03_sphere/reference/sphere.cpp\"\n.text");
