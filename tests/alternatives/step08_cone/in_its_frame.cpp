// right: the ray is transformed to a frame with the axis as z
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

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
