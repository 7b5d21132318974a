#include "steps/step04_plane/plane.hpp"

#include "common/compensated.hpp"
#include "common/vector.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // t = ⟨o − o_r, n⟩ / ⟨d, n⟩ (MRT §4). At a grazing ray both products cancel, so both are
    // compensated: t is within 4 ulp at any angle, and no epsilon decides what is parallel.
    const Real distance = compensated_dot(plane.normal, plane.point, ray.origin);
    const Real approach = compensated_dot(plane.normal, ray.direction);
    const Real t = distance / approach;
    if (!interval.contains(t)) return std::nullopt;  // a parallel ray has t = ±∞ or NaN
    return t;
}

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    return unit(plane.normal);
}

}  // namespace rt
