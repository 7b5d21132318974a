// right: ⟨p − o, Z⟩² = cos² ‖p − o‖², the form of other textbooks
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Real cos_squared =
        cone.height * cone.height / (cone.height * cone.height + cone.radius * cone.radius);
    const Vec3 o = ray.origin - cone.apex;
    const Vec3& d = ray.direction;
    const Real d_z = dot(d, cone.axis);
    const Real o_z = dot(o, cone.axis);
    const Real a = d_z * d_z - cos_squared * dot(d, d);
    const Real b = d_z * o_z - cos_squared * dot(d, o);
    const Real c = o_z * o_z - cos_squared * dot(o, o);
    const Real q = -(b + std::copysign(std::sqrt(std::max(b * b - a * c, Real(0))), b));
    if (!(b * b - a * c >= 0)) return std::nullopt;
    const Real first = q / a;
    const Real second = c / q;
    for (const Real t : {std::min(first, second), std::max(first, second)}) {
        const Real z = o_z + t * d_z;
        if (0 <= z && z <= cone.height && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
