#include "steps/step07_cylinder/cylinder.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // The computation is relative to the point of the line closest to the center: the errors then
    // depend on the size of the cylinder and not on the distance of the origin.
    const Vec3 from_center = ray.origin - cylinder.center;
    const Real t_near = -dot(from_center, ray.direction) / dot(ray.direction, ray.direction);
    const Vec3 p = fused_at(from_center, t_near, ray.direction);

    // v × Z is the component of v across the axis, rotated by 90°: the (x_p, y_p) of MRT §7 without
    // a choice of X and Y. In this cross-section the cylinder is a circle, intersected as stage 3's
    // sphere. For a ray along the axis a = 0, everything is NaN, and the ray misses.
    const Vec3 o = cross(p, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const Real a = dot(d, d);
    const Real t_closest = -dot(o, d) / a;
    const Vec3 closest = o + t_closest * d;
    const Real half_chord_squared = cylinder.radius * cylinder.radius - dot(closest, closest);
    if (!(half_chord_squared >= 0)) return std::nullopt;  // NaN must miss

    // From a point of the cylinder itself one root is 0, and not the rounding error beside it.
    const auto starts_on_side = [&] {
        const Vec3 from_axis = cross(from_center, cylinder.axis);
        return dot(from_axis, from_axis) == cylinder.radius * cylinder.radius;
    };

    // For a ray in the plane of a rim, the sign of the rise determines which root is within.
    const Real z_of_p = dot(p, cylinder.axis);
    const Real rise = dot_along(ray.direction, cylinder.axis);

    // This close to both roots, a difference is as accurate as a quotient. (r / |d|)² might leave
    // the range of numbers: two square roots do not.
    const Real half_chord = std::sqrt(half_chord_squared) / std::sqrt(a);
    for (const Real from_p : {t_closest - half_chord, t_closest + half_chord}) {
        const Real z = z_of_p + from_p * rise;
        Real t = t_near + from_p;
        if (std::abs(t) < half_chord && starts_on_side()) t = 0;
        if (std::abs(z) <= cylinder.height / 2 && interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 from_center = point - cylinder.center;
    return unit(from_center - dot(from_center, cylinder.axis) * cylinder.axis);
}

}  // namespace rt
