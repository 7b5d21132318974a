// right: a unit direction, Pythagoras, and t divided by the length in the end
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

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
