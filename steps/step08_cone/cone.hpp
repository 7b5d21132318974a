// Stage 8: cones (MRT §8, with (r/h)² instead of r/h).
//
//   MRT            here
//   o, Z           cone.apex, cone.axis; X and Y are any axes that complete Z
//   r, h           cone.radius, cone.height
//   z_p            ⟨p − o, Z⟩
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/ray.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray hits the lateral surface of the
/// cone, from outside or from inside. Returns nothing if there is none, if the ray runs along the
/// surface, or if a coordinate is NaN. The cone has one nappe and no base; the apex and the rim
/// belong to it. There is no epsilon: the cone, the direction and its angle to the surface may be
/// of any size in the range of docs/reference/stability.md, and the axis at any angle to the
/// vertical.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval);

/// The unit normal at a point of the lateral surface. It points away from the axis and, because of
/// the slope, back toward the apex. At the apex, where no direction is distinguished, it is −axis.
[[nodiscard]] Vec3 normal(const Cone& cone, Vec3 point);

}  // namespace rt
