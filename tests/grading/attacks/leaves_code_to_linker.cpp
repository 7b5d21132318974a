// attack: is an object that a compiler would complete at the link
// ceiling: as a stub
// compiles: no
// message: LTO
// message without: nm:
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".section .gnu.lto_.profile.1, \"\"\n.byte 0\n.comm __gnu_lto_slim, 1");
