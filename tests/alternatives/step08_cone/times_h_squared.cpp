// right: MRT §8 times h², without a division
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Vec3 z = cone.axis;
    const Vec3 oc = ray.origin - cone.apex;
    const Vec3 d = ray.direction - dot(ray.direction, z) * z;
    const Vec3 o = oc - dot(oc, z) * z;
    const Real dz = dot(ray.direction, z);
    const Real oz = dot(oc, z);
    const Real hh = cone.height * cone.height;
    const Real rr = cone.radius * cone.radius;
    const Real a = hh * dot(d, d) - rr * dz * dz;
    const Real b = 2 * (hh * dot(d, o) - rr * dz * oz);
    const Real c = hh * dot(o, o) - rr * oz * oz;
    const Real delta = b * b - 4 * a * c;
    if (!(delta >= 0)) return std::nullopt;
    const auto counts = [&](Real t) {
        const Real height = oz + t * dz;
        return 0 <= height && height <= cone.height && interval.contains(t);
    };
    if (a == 0) return counts(-c / b) ? std::optional(-c / b) : std::nullopt;
    const Real root = std::sqrt(delta);
    const auto [near, far] = std::minmax({(-b - root) / (2 * a), (-b + root) / (2 * a)});
    if (counts(near)) return near;
    return counts(far) ? std::optional(far) : std::nullopt;
}

}  // namespace rt
