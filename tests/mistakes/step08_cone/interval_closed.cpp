// origin: a student's: ≤ in place of <
// caught by: only hits strictly inside the interval count (contract)
// sentence: A hit at an end of the interval counts for you: a surface that the ray leaves is met at t = 0. Only hits strictly inside count: interval.contains(t).
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Real slope = cone.radius / cone.height;
    const Real k = slope * slope;
    const Vec3 from_apex = ray.origin - cone.apex;
    const Vec3 o = cross(from_apex, cone.axis);
    const Vec3 d = cross(ray.direction, cone.axis);
    const Real o_z = dot(from_apex, cone.axis);
    const Real d_z = dot(ray.direction, cone.axis);
    const Real a = dot(d, d) - k * d_z * d_z;
    const Real b = 2 * (dot(o, d) - k * o_z * d_z);
    const Real c = dot(o, o) - k * o_z * o_z;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    std::array<Real, 2> roots = {-c / b, -c / b};
    if (a != 0)
        roots = {(-b - std::sqrt(discriminant)) / (2 * a),
                 (-b + std::sqrt(discriminant)) / (2 * a)};
    if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    for (const Real t : roots) {
        const Real z = o_z + t * d_z;
        if (0 <= z && z <= cone.height && interval.min <= t && t <= interval.max) return t;
    }
    return std::nullopt;
}

}  // namespace rt
