// origin: MRT §8 by §2, erratum 3
// caught by: the axis may point anywhere (MRT §8)
// sentence: Your X is (0, 1, 0) ∧ Z as printed: where the axis is tilted it is shorter than 1, and the cone is wider than it should be. Make it unit length.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Vec3 z = cone.axis;
    const bool vertical = z.x == 0 && z.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : cross(Vec3(0, 1, 0), z);
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
