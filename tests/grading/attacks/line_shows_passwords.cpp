// attack: has the compiler show a line of /etc/passwd as that of an error, by a line directive
// ceiling: as a stub
// compiles: no
// message without: root:
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

// clang-format off
#line 1 "/etc/passwd"
int broken(
