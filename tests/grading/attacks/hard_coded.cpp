// attack: contains a table of the visible answers
// ceiling: 5
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere&, Interval) {
    if (ray.origin == Vec3(0, 1, 5)) return 5;
    if (ray.origin == Vec3(-3, 0, -2)) return Real(1.5);
    return std::nullopt;
}

}  // namespace rt
