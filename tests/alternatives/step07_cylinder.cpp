// right as_printed around intersect: MRT §7 with a chosen X and Y, and a test for a = 0
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 z = cylinder.axis;
    const Vec3 aside = std::abs(z.y) < Real(0.9) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = unit(cross(aside, z));
    const Vec3 y = cross(z, x);
    const Vec3 o = ray.origin - cylinder.center;
    const Vec3& d = ray.direction;
    const Real a = dot(d, x) * dot(d, x) + dot(d, y) * dot(d, y);
    const Real b = 2 * (dot(d, x) * dot(o, x) + dot(d, y) * dot(o, y));
    const Real c =
        dot(o, x) * dot(o, x) + dot(o, y) * dot(o, y) - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
        const Real z_p = dot(o, z) + t * dot(d, z);
        if (std::abs(z_p) <= cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt

// right axis_taken_away around intersect: v − ⟨v, Z⟩ Z in place of v ∧ Z
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const auto across = [&cylinder](Vec3 v) { return v - dot(v, cylinder.axis) * cylinder.axis; };
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = across(from_center);
    const Vec3 d = across(ray.direction);
    const Real a = dot(d, d);
    const Real half_b = dot(o, d);
    const Real c = dot(o, o) - cylinder.radius * cylinder.radius;
    const Real discriminant = half_b * half_b - a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    for (const int sign : {-1, 1}) {
        const Real t = (-half_b + Real(sign) * std::sqrt(discriminant)) / a;
        const Real z = dot(from_center + t * ray.direction, cylinder.axis);
        if (interval.contains(t) && std::abs(z) <= cylinder.height / 2) return t;
    }
    return std::nullopt;
}

}  // namespace rt

// right in_its_frame around intersect: the ray is transformed to a frame with the axis as z
#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const auto& [x, y, z] = orthonormal_basis(cylinder.axis);
    const Vec3 from = ray.origin - cylinder.center;
    const Vec3 o(dot(from, x), dot(from, y), dot(from, z));
    const Vec3 d(dot(ray.direction, x), dot(ray.direction, y), dot(ray.direction, z));
    const Real a = d.x * d.x + d.y * d.y;
    const Real b = 2 * (o.x * d.x + o.y * d.y);
    const Real c = o.x * o.x + o.y * o.y - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t) && 2 * std::abs(o.z + t * d.z) <= cylinder.height) return t;
    return std::nullopt;
}

}  // namespace rt

// right unit_direction around intersect: a unit direction, and its part across the axis
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
