// attack: includes, by .incbin, the reference that other stages are linked to
// ceiling: as a stub
// compiles: no
// message: step03_sphere.o
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".section .rodata\n.incbin \"../seats/references/step03_sphere.o\"\n.text");
