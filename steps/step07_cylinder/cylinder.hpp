// Stage 7: cylinders (MRT §7).
//
//   MRT            here
//   o, Z           cylinder.center, cylinder.axis; X and Y are any axes that complete Z
//   r, h           cylinder.radius, cylinder.height
//   z_p            ⟨p − o, Z⟩
#pragma once

#include "common/geometry/cylinder.hpp"
#include "common/geometry/ray.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray hits the lateral surface of the
/// cylinder, from outside or from inside. Returns nothing if there is none, if the ray is parallel
/// to the axis, or if a coordinate is NaN. There are no caps, and both rims belong to the surface.
/// There is no epsilon, and no a that cancels: lengths and directions may be of any size in the
/// range of docs/reference/stability.md, the ray at any angle to the axis and the axis at any angle
/// to the vertical.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder,
                                            Interval interval);

/// The unit normal at a point of the lateral surface, pointing away from the axis.
[[nodiscard]] Vec3 normal(const Cylinder& cylinder, Vec3 point);

}  // namespace rt
