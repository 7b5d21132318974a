// attack: gives each answer after 0.9 seconds
// ceiling: as a stub
// message: longer than
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    usleep(900000);
    return std::nullopt;
}

}  // namespace rt
