// attack: shows /etc/passwd in the compiler's errors
// ceiling: as a stub
// compiles: no
// told: /etc/passwd
// untold: root:
// stubs: intersect normal color_from_normal torch
#include "/etc/passwd"
#include "steps/step03_sphere/sphere.hpp"
