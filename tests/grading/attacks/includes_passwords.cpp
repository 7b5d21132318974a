// attack: shows /etc/passwd in the compiler's errors
// ceiling: as a stub
// compiles: no
// message: /etc/passwd
// message without: root:
// stubs: intersect normal color_from_normal torch
#include "/etc/passwd"
#include "steps/step03_sphere/sphere.hpp"
