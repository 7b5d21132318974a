// attack: replaces write by a variable in what becomes code
// ceiling: as a stub
// compiles: no
// message: defines write
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".section .text.write, \"a\"\n.globl write\n.type write, @object\nwrite: .byte 0xc3");
