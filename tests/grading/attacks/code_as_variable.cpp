// attack: replaces write by code that is declared a weak variable
// ceiling: as a stub
// compiles: no
// message: defines write
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".text\n.weak write\n.type write, @object\nwrite: ret");
