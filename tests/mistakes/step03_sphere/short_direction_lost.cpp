// origin: derived: A < 1e-9 taken for a ray without a direction
// caught by: small spheres and short directions count: no epsilon on Δ or ‖d‖² (contract)
// sentence: You compare ‖d‖² with a constant. A direction may be short: only 0 is no direction.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 from_center = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(from_center, ray.direction);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a < Real(1e-9)) return std::nullopt;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

}  // namespace rt
