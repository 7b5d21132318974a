// attack: shows the environment of the compiler
// ceiling: as a stub
// compiles: no
// message: /proc/self/environ
// message without: PATH=
// stubs: intersect normal color_from_normal torch
#include "/proc/self/environ"
#include "steps/step03_sphere/sphere.hpp"
