// origin: common in student repositories: t > 1e-4 against "shadow acne"
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You compare t with a constant above 0. t counts in the length of the direction and may be of any size: only the interval decides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Real k = (cone.radius / cone.height) * (cone.radius / cone.height);
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
    const Real root = std::sqrt(discriminant);
    Real first = (-b - root) / (2 * a);
    Real second = (-b + root) / (2 * a);
    if (a == 0) first = second = -c / b;
    if (second < first) std::swap(first, second);
    for (const Real t : {first, second}) {
        const Real z = o_z + t * d_z;
        if (0 <= z && z <= cone.height && interval.contains(t) && t > Real(1e-4)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
