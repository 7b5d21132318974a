// attack: replaces memcpy in assembler, hidden from other objects
// ceiling: as a stub
// compiles: no
// message: defines memcpy
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".globl memcpy\n.hidden memcpy\nmemcpy: ret");
