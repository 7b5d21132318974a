// attack: doubles templates, forty levels deep
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

template <int Depth, int Place>
struct Bomb {
    static constexpr long value =
        Bomb<Depth - 1, 2 * Place>::value + Bomb<Depth - 1, 2 * Place + 1>::value;
};
template <int Place>
struct Bomb<0, Place> {
    static constexpr long value = Place;
};
static_assert(Bomb<28, 0>::value != 1);
