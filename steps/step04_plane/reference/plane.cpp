#include "steps/step04_plane/plane.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

namespace rt {

namespace {

/// Returns whether the vector is along an axis: then no product with it has more than one term,
/// nothing can cancel, and the plain product is as accurate as the compensated one.
bool along_an_axis(Vec3 v) {
    return v.x == 0 ? v.y == 0 || v.z == 0 : v.y == 0 && v.z == 0;
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // t = ⟨o − o_r, n⟩ / ⟨d, n⟩ (MRT §4). For a grazing ray both products cancel, so both are
    // compensated: the error of t is at most 4 ulp at any angle (docs/reference/error_bounds.md),
    // and no epsilon is needed to detect a parallel ray.
    const auto& [point, n] = plane;
    const bool plain = along_an_axis(n);
    const Real distance =
        plain ? dot(n, point - ray.origin) : compensated_dot(n, point, ray.origin);
    const Real approach = plain ? dot(n, ray.direction) : compensated_dot(n, ray.direction);
    const Real t = distance / approach;
    if (!interval.contains(t)) return std::nullopt;  // a parallel ray has t = ±∞ or NaN
    return t;
}

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    return unit(plane.normal);
}

}  // namespace rt
