#include "steps/step08_cone/cone.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

/// h² (x² + y²) − r² z² of a vector, factored: near the cone the two terms almost cancel.
Real off_cone(const Cone& cone, Vec3 v) {
    const Real across = cone.height * length(cross(v, cone.axis));
    const Real along = cone.radius * std::abs(dot(v, cone.axis));
    return (across - along) * (across + along);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cone& given, Interval interval) {
    // In units in which the sizes of the cone and the direction are about 1: the products below
    // have six factors, and would leave the range of float at sizes of 1e-6 and 1e6.
    const Real shrink = 1 / power_of_two_below(std::max(given.radius, given.height));
    const Real slow = 1 / power_of_two_below(largest_component(ray.direction));
    const Cone cone{
        .axis = given.axis, .radius = shrink * given.radius, .height = shrink * given.height};
    const Vec3 from_apex = shrink * (ray.origin - given.apex);
    const Vec3 d = slow * ray.direction;

    // MRT §8's quadratic, times h², relative to the point of the line closest to the apex: from far
    // away the digits of its discriminant would cancel.
    const Real t_closest = -dot(from_apex, d) / dot(d, d);
    const Vec3 p = fused_at(from_apex, t_closest, d);
    const Real hh = cone.height * cone.height;
    const Real rr = cone.radius * cone.radius;

    // b² − ac is h² times this by Lagrange's identity, where m is the moment of the line.
    const Vec3 m = cross(p, d);
    const Vec3 m_across = cross(m, cone.axis);
    const Real m_along = dot(m, cone.axis);
    const Real discriminant = rr * dot(m_across, m_across) - hh * m_along * m_along;
    if (!(discriminant >= 0)) return std::nullopt;  // NaN must miss

    const Real a = off_cone(cone, d);
    const Real d_along = dot(d, cone.axis);
    const Real b =
        hh * dot(cross(p, cone.axis), cross(d, cone.axis)) - rr * dot(p, cone.axis) * d_along;
    const Real c = off_cone(cone, p);
    const Real q = -(b + std::copysign(cone.height * std::sqrt(discriminant), b));

    // The roots are q / a and c / q, so that neither is a difference. A ray along the surface has a
    // = 0: q / a is infinite, and c / q is its only root, −c / b with MRT's b. The order of the
    // roots depends on the sign of a. Through the apex c / q is 0 / 0, and both are q / a.
    const Real first = std::min(q / a, c / q);
    const Real last = std::max(q / a, c / q);

    // On the cone, z ≤ h means: at most as far from the apex as the rim. For a flat cone, z alone
    // determines that distance poorly.
    const auto is_below_rim = [&](Real root) {
        const Vec3 point = p + root * d;
        return cone.height >= cone.radius ? dot(point, cone.axis) <= cone.height
                                          : dot(point, point) <= rr + hh;
    };
    bool first_below = is_below_rim(first);
    bool last_below = is_below_rim(last);
    // If a > 0, both roots are on the same nappe. The sign of the rise determines which of them is
    // lower, and that one is below the rim if the other one is; in the plane of the rim both are.
    if (a > 0 && first_below != last_below) {
        const Real rise = dot_along(d, cone.axis);
        if (rise >= 0) first_below = true;
        if (rise <= 0) last_below = true;
    }
    for (const Real root : {first, last}) {
        // A ray that is steeper than the side hits each nappe once, this one last if it runs up the
        // axis. For other rays z decides, but here both roots may round to points behind the apex.
        const bool on_nappe =
            a < 0 ? root == (d_along > 0 ? last : first) : dot(p + root * d, cone.axis) >= 0;
        const bool below_rim = root == first ? first_below : last_below;
        Real t = (t_closest + root) * (slow / shrink);
        // From a point of the cone itself one root is 0, and not the rounding error beside it.
        if (std::abs(t_closest + root) <= (last - first) / 2 && off_cone(cone, from_apex) == 0)
            t = 0;
        if (on_nappe && below_rim && interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const Cone& cone, Vec3 point) {
    const Vec3 from_apex = point - cone.apex;
    const Vec3 across = from_apex - dot(from_apex, cone.axis) * cone.axis;
    if (across == Vec3(0)) return -cone.axis;
    return unit(cone.height * unit(across) - cone.radius * cone.axis);
}

}  // namespace rt
