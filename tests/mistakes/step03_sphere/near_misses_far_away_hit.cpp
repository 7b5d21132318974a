// origin: a student's: a negative Δ that is small beside (b/2)²
// caught by: rays aimed past the sphere miss it (MRT §3)
// sentence: You round a negative Δ up to 0 where it is small beside b²: far away, rays beside a sphere meet it. Only Δ itself decides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 oc = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real half_b = dot(oc, ray.direction);
    const Real c = dot(oc, oc) - sphere.radius * sphere.radius;
    Real delta = half_b * half_b - a * c;
    if (delta < 0 && delta > Real(-1e-10) * half_b * half_b) delta = 0;
    if (!(delta >= 0)) return std::nullopt;
    for (const Real t : {(-half_b - std::sqrt(delta)) / a, (-half_b + std::sqrt(delta)) / a})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

}  // namespace rt
