#include "steps/step07_cylinder/cylinder.hpp"

#include "common/compensated.hpp"
#include "common/vector.hpp"

#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // From the point of the line nearest to the centre: what follows rounds in its own size, not in
    // the distance of the origin.
    const Vec3 from_center = ray.origin - cylinder.center;
    const Real t_near = -dot(from_center, ray.direction) / dot(ray.direction, ray.direction);
    const Vec3 p = fused_at(from_center, t_near, ray.direction);

    // v × Z is v's part across the axis, turned a quarter: the (x_p, y_p) of MRT §7 without
    // choosing X and Y. In that cross-section the cylinder is a circle, met as stage 3 meets a
    // sphere. A ray along the axis has a = 0 there, everything NaN, and misses by itself.
    const Vec3 o = cross(p, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const Real a = dot(d, d);
    const Real t_closest = -dot(o, d) / a;
    const Vec3 closest = o + t_closest * d;
    const Real half_chord_squared = cylinder.radius * cylinder.radius - dot(closest, closest);
    if (!(half_chord_squared >= 0)) return std::nullopt;  // NaN must miss

    // So near to both roots, a difference is as good as a quotient.
    const Real half_chord = std::sqrt(half_chord_squared / a);
    for (const Real from_p : {t_closest - half_chord, t_closest + half_chord}) {
        const Real z = dot(p, cylinder.axis) + from_p * dot(ray.direction, cylinder.axis);
        const Real t = t_near + from_p;
        if (std::abs(z) <= cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 from_center = point - cylinder.center;
    return unit(from_center - dot(from_center, cylinder.axis) * cylinder.axis);
}

}  // namespace rt
