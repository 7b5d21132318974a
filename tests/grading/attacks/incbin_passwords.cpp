// attack: includes /etc/shadow by .incbin
// ceiling: as a stub
// compiles: no
// message: /etc/shadow
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".section .rodata\n.incbin \"/etc/shadow\"\n.text");
