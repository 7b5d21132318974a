// origin: invented
// caught by: the side ends at its rims, and not 0.1 % further (MRT §7)
// sentence: Your tube ends a little beyond h / 2. A rim belongs to it with ≤, without a margin.
#include <algorithm>
#include <cmath>
#include <utility>
#include "common/math/vector.hpp"
#include "steps/step07_cylinder/cylinder.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 o = ray.origin - cylinder.center;
    const Real dz = dot(ray.direction, cylinder.axis);
    const Real oz = dot(o, cylinder.axis);
    const Vec3 d2 = ray.direction - dz * cylinder.axis;
    const Vec3 o2 = o - oz * cylinder.axis;
    const Real a = dot(d2, d2);
    const Real b = 2 * dot(o2, d2);
    const Real c = dot(o2, o2) - cylinder.radius * cylinder.radius;
    if (a == 0) return std::nullopt;
    Real delta = b * b - 4 * a * c;
    if (!(delta >= 0)) return std::nullopt;
    const Real root = std::sqrt(delta);
    const Real t1 = (-b - root) / (2 * a);
    const Real t2 = (-b + root) / (2 * a);
    const Real half = cylinder.height / 2 * Real(1.000001);
    const Real z1 = oz + t1 * dz;
    const Real z2 = oz + t2 * dz;
    if (t1 > interval.min && t1 < interval.max && z1 >= -half && z1 <= half) return t1;
    if (t2 > interval.min && t2 < interval.max && z2 >= -half && z2 <= half) return t2;
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 p = point - cylinder.center;
    return unit(p - dot(p, cylinder.axis) * cylinder.axis);
}

}  // namespace rt
