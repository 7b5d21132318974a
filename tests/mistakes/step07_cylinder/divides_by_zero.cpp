// origin: MRT §7, erratum 6
// caught by: a ray along the axis misses: a = 0 (erratum 6, MRT §7)
// sentence: You divide by a, which is 0 for a ray along the axis: ∞ or NaN is no hit.
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
    if (discriminant < 0) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    const Real t = (-b - root) / (2 * a);
    const Real far = (-b + root) / (2 * a);
    const Real z = dot(from_center + t * ray.direction, cylinder.axis);
    if (std::abs(z) > cylinder.height / 2 || t <= interval.min) {
        const Real far_z = dot(from_center + far * ray.direction, cylinder.axis);
        if (std::abs(far_z) > cylinder.height / 2 || far <= interval.min || far >= interval.max)
            return std::nullopt;
        return far;
    }
    if (t >= interval.max) return std::nullopt;
    return t;
}

}  // namespace rt
