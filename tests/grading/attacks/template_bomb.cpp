// attack: doubles templates, forty levels deep
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

template <int Depth, int FileLocation>
struct Bomb {
    static constexpr long value =
        Bomb<Depth - 1, 2 * FileLocation>::value + Bomb<Depth - 1, 2 * FileLocation + 1>::value;
};
template <int FileLocation>
struct Bomb<0, FileLocation> {
    static constexpr long value = FileLocation;
};
static_assert(Bomb<28, 0>::value != 1);
