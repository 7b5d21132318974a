// attack: computes without end
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (volatile int i = 0;;) i = i + 1;
}

}  // namespace rt
