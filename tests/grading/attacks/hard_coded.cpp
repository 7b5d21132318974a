// attack: contains a table of the visible answers
// ceiling: 5
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere&, Interval) {
    if (ray.origin == Vec3(0, 1, 5)) return 5;
    if (ray.origin == Vec3(-3, 0, -2)) return Real(1.5);
    return std::nullopt;
}

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
