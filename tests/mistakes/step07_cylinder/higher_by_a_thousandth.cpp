// origin: derived: |z| ≤ 1.001 h / 2, so that no rim is lost
// caught by: the side ends at its rims, and not 0.1 % further (MRT §7)
// sentence: You let z be a little larger than h / 2: the tube ends further out. A rim belongs to it with ≤, without a margin.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = cross(from_center, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const Real a = dot(d, d);
    const Real b = 2 * dot(o, d);
    const Real c = dot(o, o) - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
        const Real z = dot(from_center + t * ray.direction, cylinder.axis);
        if (std::abs(z) <= Real(1.001) * cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
