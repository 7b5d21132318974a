// attack: starts a shell by system
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (std::system("echo harm >> @RESULTS@") == 0) return 1;
    return std::nullopt;
}

}  // namespace rt
