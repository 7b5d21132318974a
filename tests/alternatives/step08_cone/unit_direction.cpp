// right: MRT §8 with a unit direction, and vectors across the axis
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Vec3 z = cone.axis;
    const Vec3 oc = ray.origin - cone.apex;
    const Vec3 v = glm::normalize(ray.direction);
    const Real speed = glm::length(ray.direction);
    const Vec3 d = v - dot(v, z) * z;
    const Vec3 o = oc - dot(oc, z) * z;
    const Real dz = dot(v, z);
    const Real oz = dot(oc, z);
    const Real k = (cone.radius / cone.height) * (cone.radius / cone.height);
    const Real a = dot(d, d) - k * dz * dz;
    const Real b = 2 * (dot(d, o) - k * dz * oz);
    const Real c = dot(o, o) - k * oz * oz;
    const Real delta = b * b - 4 * a * c;
    if (!(delta >= 0)) return std::nullopt;
    Real first = -c / b;
    Real second = -c / b;
    if (a != 0) {
        first = (-b - std::sqrt(delta)) / (2 * a);
        second = (-b + std::sqrt(delta)) / (2 * a);
        if (first > second) std::swap(first, second);
    }
    for (const Real distance : {first, second}) {
        const Real height = oz + distance * dz;
        if (height >= 0 && height <= cone.height && interval.contains(distance / speed))
            return distance / speed;
    }
    return std::nullopt;
}

}  // namespace rt
