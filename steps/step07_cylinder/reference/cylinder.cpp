#include "steps/step07_cylinder/cylinder.hpp"

#include "common/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // v × Z is v's part across the axis, turned a quarter: the (x_p, y_p) of MRT §7 without
    // choosing X and Y. In that cross-section the cylinder is a circle, met as stage 3 meets a
    // sphere. A ray along the axis has a = 0 there, everything NaN, and misses by itself.
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = cross(from_center, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const Real a = dot(d, d);
    const Real b = -dot(o, d);
    const Vec3 closest = o + b / a * d;
    const Real half_chord_squared = cylinder.radius * cylinder.radius - dot(closest, closest);
    if (!(half_chord_squared >= 0)) return std::nullopt;  // NaN must miss

    const Real c = dot(o, o) - cylinder.radius * cylinder.radius;
    const Real q = b + std::copysign(std::sqrt(half_chord_squared * a), b);
    const Real t1 = q / a;
    const Real t2 = c / q;
    for (const Real t : {std::min(t1, t2), std::max(t1, t2)}) {
        const Real z = dot(from_center, cylinder.axis) + t * dot(ray.direction, cylinder.axis);
        if (std::abs(z) <= cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 from_center = point - cylinder.center;
    return unit(from_center - dot(from_center, cylinder.axis) * cylinder.axis);
}

}  // namespace rt
