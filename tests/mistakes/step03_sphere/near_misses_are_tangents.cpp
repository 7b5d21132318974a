// origin: derived: Δ > −1e-6 counted as 0, so that tangents are not lost
// caught by: small spheres and short directions count: no epsilon on Δ or ‖d‖² (contract)
// sentence: You take a Δ slightly below 0 for 0. Δ shrinks with the sphere and with the direction: rays that pass a small sphere hit it.
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
    if (!(discriminant > Real(-1e-6))) return std::nullopt;
    const Real root = std::sqrt(std::max(discriminant, Real(0)));
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

}  // namespace rt
