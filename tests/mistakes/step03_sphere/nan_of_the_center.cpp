// origin: a student's: std::isnan of the ray alone
// caught by: a ray or shape with NaN is a miss (contract)
// sentence: You test the ray for NaN, and not the sphere: its center may be NaN, too. Write comparisons that are false for NaN, !(Δ >= 0), and test t with interval.contains.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    if (std::isnan(dot(ray.origin, ray.direction))) return std::nullopt;
    const Vec3 from_center = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(from_center, ray.direction);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (!(t <= interval.min || t >= interval.max)) return t;
    return std::nullopt;
}

}  // namespace rt
