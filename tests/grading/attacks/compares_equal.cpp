// attack: answers with infinity, to which a relative tolerance is infinite
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <limits>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    return std::numeric_limits<Real>::infinity();
}

}  // namespace rt
