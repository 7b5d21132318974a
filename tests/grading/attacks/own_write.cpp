// attack: replaces write, which main uses to answer
// ceiling: as a stub
// compiles: no
// message: defines write
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/types.h>

extern "C" ssize_t write(int, const void*, size_t size) {
    return ssize_t(size);
}
