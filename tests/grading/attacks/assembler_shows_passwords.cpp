// attack: shows /etc/passwd in the assembler's errors
// ceiling: as a stub
// compiles: no
// message without: root:
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

asm(".include \"/etc/passwd\"");
