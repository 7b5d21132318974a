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
    Real first = -c / b;
    Real second = -c / b;
    if (a != 0) {
        first = (-b - std::sqrt(delta)) / (2 * a);
        second = (-b + std::sqrt(delta)) / (2 * a);
        if (first > second) std::swap(first, second);
    }
    for (const Real t : {first, second}) {
        const Real height = oz + t * dz;
        if (height >= 0 && height <= cone.height && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
