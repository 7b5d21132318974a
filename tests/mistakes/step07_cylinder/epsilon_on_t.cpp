// origin: common in student repositories: t > 1e-4 against "shadow acne"
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You compare t with a constant above 0. t counts in the length of the direction and may be of any size: only the interval decides.
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
        if (std::abs(z) <= cylinder.height / 2 && interval.contains(t) && t > Real(1e-4)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
