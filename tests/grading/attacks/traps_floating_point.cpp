// attack: leaves floating-point traps on
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cfenv>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    feenableexcept(FE_ALL_EXCEPT);
    return std::nullopt;
}

}  // namespace rt
