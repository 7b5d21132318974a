// right: the ray is transformed to a frame with the axis as z
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

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
