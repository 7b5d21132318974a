// Stage 8: cones (MRT §8, with (r/h)² in place of r/h).
//
//   MRT            here
//   o, Z           cone.apex, cone.axis; X and Y may be any that complete Z
//   r, h           cone.radius, cone.height
//   z_p            ⟨p − o, Z⟩
#pragma once

#include "common/ray.hpp"
#include "common/shapes.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray meets the side of the cone, from
/// outside or from inside; nothing if there is none, if the ray runs along the side, or if a
/// coordinate is NaN. One nappe, no base; the apex and the rim belong to the side.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval);

/// The unit normal at a point of the side: away from the axis and, by the slope, back towards the
/// apex. At the apex, where every direction would do, it is −axis.
[[nodiscard]] Vec3 normal(const Cone& cone, Vec3 point);

}  // namespace rt
