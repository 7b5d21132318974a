// attack: floods the channel with zeros
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const char zeros[65536] = {};
    while (write(3, zeros, sizeof zeros) > 0) continue;
    return 1;
}

}  // namespace rt
