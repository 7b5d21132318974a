// attack: replaces memcmp by one that always returns equal
// ceiling: as a stub
// compiles: no
// message: defines memcmp
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstddef>

extern "C" int memcmp(const void*, const void*, std::size_t) {
    return 0;
}
