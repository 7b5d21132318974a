// right: the root that cancels as c / q
#include <algorithm>

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 from_center = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(from_center, ray.direction);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
    const Real first = std::min(q / a, c / q);
    const Real second = std::max(q / a, c / q);
    if (interval.contains(first)) return first;
    if (interval.contains(second)) return second;
    return std::nullopt;
}

}  // namespace rt
