// origin: derived: |z| ≤ 1.0001 h / 2, unless the axis is one of the world's
// caught by: the side ends at its rims, and not 0.1 % further (MRT §7)
// sentence: You let the rims of a slanted tube be a little higher. They belong to the side with ≤, without a margin, for every axis.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 z = cylinder.axis;
    const Vec3 aside = std::abs(z.y) < Real(0.9) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = unit(cross(aside, z));
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
        if (std::abs(z_p) <= cylinder.height / 2 *
                                 (std::abs(z.x) + std::abs(z.y) + std::abs(z.z) > Real(1.001)
                                      ? Real(1.0001)
                                      : 1) &&
            interval.contains(t))
            return t;
    }
    return std::nullopt;
}

}  // namespace rt
