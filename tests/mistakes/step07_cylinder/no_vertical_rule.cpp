// origin: MRT §7 by §2, its second remark forgotten
// caught by: a ray across meets the near side (MRT §7)
// sentence: Where the axis is upright, (0, 1, 0) ∧ Z is 0, and 0 / 0 is NaN: the cylinder is not seen. Take X = (1, 0, 0) there, as in MRT §2.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 z = cylinder.axis;
    const Vec3 x = unit(cross(Vec3(0, 1, 0), z));
    const Vec3 y = cross(z, x);
    const Vec3 o = ray.origin - cylinder.center;
    const Vec3& d = ray.direction;
    const Real a = dot(d, x) * dot(d, x) + dot(d, y) * dot(d, y);
    const Real b = 2 * (dot(d, x) * dot(o, x) + dot(d, y) * dot(o, y));
    const Real c =
        dot(o, x) * dot(o, x) + dot(o, y) * dot(o, y) - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
        const Real z_p = dot(o, z) + t * dot(d, z);
        if (std::abs(z_p) <= cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
