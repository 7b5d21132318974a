// attack: replaces operator new
// ceiling: as a stub
// compiles: no
// message: which all programs share
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <new>

void* operator new(std::size_t) {
    return std::malloc(1 << 20);
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
