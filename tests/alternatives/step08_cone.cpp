// right by_cosine around intersect: ⟨p − o, Z⟩² = cos² ‖p − o‖², the form of other textbooks
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

// right in_its_frame around intersect: the ray is transformed to a frame with the axis as z
#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const auto& [x, y, z] = orthonormal_basis(cone.axis);
    const Vec3 from = ray.origin - cone.apex;
    const Vec3 o(dot(from, x), dot(from, y), dot(from, z));
    const Vec3 d(dot(ray.direction, x), dot(ray.direction, y), dot(ray.direction, z));
    const Real slope = cone.radius / cone.height;
    const Real a = d.x * d.x + d.y * d.y - slope * slope * d.z * d.z;
    const Real b = 2 * (o.x * d.x + o.y * d.y - slope * slope * o.z * d.z);
    const Real c = o.x * o.x + o.y * o.y - slope * slope * o.z * o.z;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    Real first = (-b - root) / (2 * a);
    Real second = (-b + root) / (2 * a);
    if (a == 0) first = second = -c / b;
    if (second < first) std::swap(first, second);
    for (const Real t : {first, second}) {
        const Real height = o.z + t * d.z;
        if (interval.contains(t) && 0 <= height && height <= cone.height) return t;
    }
    return std::nullopt;
}

}  // namespace rt

// right textbook around intersect: MRT §8 with (r/h)², the roots ordered, −c / b where a = 0
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
    std::array<Real, 2> roots = {-c / b, -c / b};
    if (a != 0)
        roots = {(-b - std::sqrt(discriminant)) / (2 * a),
                 (-b + std::sqrt(discriminant)) / (2 * a)};
    if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    for (const Real t : roots) {
        const Real z = o_z + t * d_z;
        if (0 <= z && z <= cone.height && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt

// right times_h_squared around intersect: MRT §8 times h², without a division
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

// right unit_direction around intersect: MRT §8 with a unit direction, and vectors across the axis
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
