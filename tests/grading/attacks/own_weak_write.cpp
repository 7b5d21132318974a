// attack: replaces write and _exit by functions whose symbols are declared weak objects
// ceiling: as a stub
// compiles: perhaps
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(R"(
    .text
    .weak write
    .type write, @object
write:
    .weak _exit
    .type _exit, @object
_exit:
    ret
)");
