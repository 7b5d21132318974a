// Stage 6: squares (MRT §6 in their own basis; HAI by u and v; CR §2.3 by edge tests).
//
//   documents      here
//   o, X, Y, Z     square.center, square.basis.x, .y, .z (MRT)
//   h              square.side (MRT)
//   C, U, V        center − (U + V) / 2, side · basis.x, side · basis.y (HAI)
//   u, v           square_uv(…).x, .y (HAI)
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/square.hpp"

#include <optional>

namespace rt {

/// The t strictly inside the interval at which the ray hits the square. Returns nothing if there is
/// none, or if a coordinate is NaN. Edges belong to the square. A one-sided square is hit only
/// where ⟨direction, normal⟩ < 0 (HAI). The basis may be any rotation, also one about a vertical Z.
/// There is no epsilon: the square, the direction and its angle to the plane may be of any size in
/// the range of docs/reference/stability.md.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Square& square,
                                            Interval interval);

/// HAI's u and v of a point in the square's plane: inside the square from 0 to 1 along its x and y,
/// (0, 0) at its corner C and (1, 1) at the opposite corner.
[[nodiscard]] Vec2 square_uv(const Square& square, Vec3 point);

/// The unit normal, basis.z, the same at every point.
[[nodiscard]] Vec3 normal(const Square& square, Vec3 point);

}  // namespace rt
