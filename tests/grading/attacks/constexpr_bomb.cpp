// attack: computes while it is compiled
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

constexpr long forever(long from) {
    for (long i = 0; i < 200000; ++i)  // the compiler's own limit
        for (long k = 0; k < 200000; ++k) from += k;
    return from;
}
template <long FileLocation>
constexpr long value = forever(FileLocation) + value<FileLocation - 1>;
template <>
constexpr long value<0> = 0;
static_assert(value<500> != 1);
