// attack: makes main a weak name of its own function, by a pragma
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"
extern "C" int evil() {
    return 0;
}
#pragma weak main = evil
