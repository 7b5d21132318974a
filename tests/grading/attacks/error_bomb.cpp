// attack: makes the compiler print without end
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

template <int Depth>
struct Long : Long<Depth - 1>, Long<Depth - 2> {
    static_assert(Depth < 0, "an error for every depth");
};
template struct Long<800>;
