// attack: replaces malloc
// ceiling: as a stub
// compiles: no
// message: defines malloc
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

extern "C" void* malloc(unsigned long) {
    return nullptr;
}
