// attack: brings an entry point of its own
// ceiling: as a stub
// compiles: no
// message: defines _start
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

extern "C" [[noreturn]] void _start() {
    for (;;) continue;
}
