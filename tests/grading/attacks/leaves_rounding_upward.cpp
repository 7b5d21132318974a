// attack: leaves the rounding mode upward, to mislead the comparison
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cfenv>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::fesetround(FE_UPWARD);
    return std::nullopt;
}

}  // namespace rt
