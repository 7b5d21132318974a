// attack: removes the results of others
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdio>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::remove("@RESULTS@");
    return std::nullopt;
}

}  // namespace rt
