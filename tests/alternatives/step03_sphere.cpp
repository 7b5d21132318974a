// right citardauq around intersect: the root that cancels as c / q
#include <algorithm>

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

// right geometric around intersect: a unit direction, Pythagoras, and t divided by the length in
// the end
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Real size = length(ray.direction);
    const Vec3 unit_direction = ray.direction / size;
    const Vec3 to_center = sphere.center - ray.origin;
    const Real along = dot(to_center, unit_direction);
    const Real beside = dot(to_center, to_center) - along * along;
    const Real left = sphere.radius * sphere.radius - beside;
    if (!(left >= 0)) return std::nullopt;
    const Real near = (along - std::sqrt(left)) / size;
    const Real far = (along + std::sqrt(left)) / size;
    if (interval.contains(near)) return near;
    if (interval.contains(far)) return far;
    return std::nullopt;
}

}  // namespace rt

// right textbook around intersect: PHY's A t² + B t + C = 0 as printed
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 from_center = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(from_center, ray.direction);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

}  // namespace rt
