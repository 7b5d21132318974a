// attack: replaces sqrt
// ceiling: as a stub
// compiles: no
// message: defines sqrt
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

extern "C" double sqrt(double) {
    return 1;
}
