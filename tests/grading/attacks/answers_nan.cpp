// attack: answers every query with NaN
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <limits>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    return std::numeric_limits<Real>::quiet_NaN();
}

}  // namespace rt
