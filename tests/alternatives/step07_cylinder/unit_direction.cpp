// right: a unit direction, and its part across the axis
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 v = glm::normalize(ray.direction);
    const Real speed = glm::length(ray.direction);
    const Vec3 z = cylinder.axis;
    const Vec3 oc = ray.origin - cylinder.center;
    const Vec3 d = v - glm::dot(v, z) * z;
    const Vec3 o = oc - glm::dot(oc, z) * z;
    const Real a = glm::dot(d, d);
    if (a == 0) return std::nullopt;
    const Real b = glm::dot(d, o);
    const Real c = glm::dot(o, o) - cylinder.radius * cylinder.radius;
    const Real delta = b * b - a * c;
    if (!(delta >= 0)) return std::nullopt;
    for (const Real distance : {(-b - std::sqrt(delta)) / a, (-b + std::sqrt(delta)) / a}) {
        const Real height = glm::dot(oc, z) + distance * glm::dot(v, z);
        if (std::abs(height) <= cylinder.height / 2 && interval.contains(distance / speed))
            return distance / speed;
    }
    return std::nullopt;
}

}  // namespace rt
