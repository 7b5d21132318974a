// Stage 4: planes (MRT §4; M1; PHY, situation A).
//
//   documents      here
//   o_r, d_r       ray.origin, ray.direction (MRT); o, d (M1); r_0, v (PHY)
//   o, a, r_p      plane.point (MRT; M1; PHY)
//   n              plane.normal
#pragma once

#include "common/geometry/plane.hpp"
#include "common/geometry/ray.hpp"

#include <optional>

namespace rt {

/// The t strictly inside the interval at which the ray hits the plane, from either side. Returns
/// nothing if there is none, if the ray runs in the plane or parallel to it, or if a coordinate is
/// NaN. There is no epsilon: the direction and its angle to the plane may be of any size in the
/// range of docs/reference/stability.md.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval);

/// The plane's normal scaled to unit length, the same at every point.
[[nodiscard]] Vec3 normal(const Plane& plane, Vec3 point);

}  // namespace rt
