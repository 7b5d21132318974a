// origin: MRT §8 by §2, its second remark forgotten
// caught by: at z_p = h the radius is r: (r/h)², not r/h (erratum 4, MRT §8)
// sentence: Where the axis is upright, (0, 1, 0) ∧ Z is 0, and 0 / 0 is NaN: the cone is not seen. Take X = (1, 0, 0) there, as in MRT §2.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Vec3 z = cone.axis;
    const Vec3 x = unit(cross(Vec3(0, 1, 0), z));
    const Vec3 y = cross(z, x);
    const Real k = (cone.radius / cone.height) * (cone.radius / cone.height);
    const Vec3 o = ray.origin - cone.apex;
    const Vec3& d = ray.direction;
    const Real a = dot(d, x) * dot(d, x) + dot(d, y) * dot(d, y) - k * dot(d, z) * dot(d, z);
    const Real b = 2 * (dot(d, x) * dot(o, x) + dot(d, y) * dot(o, y) - k * dot(d, z) * dot(o, z));
    const Real c = dot(o, x) * dot(o, x) + dot(o, y) * dot(o, y) - k * dot(o, z) * dot(o, z);
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    std::array<Real, 2> roots = {-c / b, -c / b};
    if (a != 0)
        roots = {(-b - std::sqrt(discriminant)) / (2 * a),
                 (-b + std::sqrt(discriminant)) / (2 * a)};
    if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    for (const Real t : roots) {
        const Real z_p = dot(o, z) + t * dot(d, z);
        if (0 <= z_p && z_p <= cone.height && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
