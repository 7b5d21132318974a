// origin: common in student repositories: a unit direction, and a distance > 1e-4
// caught by: small spheres and short directions count: no epsilon on Δ or ‖d‖² (contract)
// sentence: You drop hits that are nearer than a fixed distance. A small sphere close by is seen as well as a large one: only the interval decides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 from_center = ray.origin - sphere.center;
    const Real size = length(ray.direction);
    const Real b = dot(from_center, ray.direction / size);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - c;
    if (!(discriminant >= 0)) return std::nullopt;
    for (const Real distance : {-b - std::sqrt(discriminant), -b + std::sqrt(discriminant)})
        if (interval.contains(distance / size) && distance > Real(1e-4)) return distance / size;
    return std::nullopt;
}

}  // namespace rt
