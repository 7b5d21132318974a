// Stage 5: triangles (MRT §5 by half-planes; M1 by barycentric coordinates; CR §4.1 by areas).
//
//   documents        here
//   a, b, c          triangle.a, triangle.b, triangle.c (CR: c0, c1, c2)
//   n                (b − a) × (c − a)
//   α, β, γ          barycentric(…).x, .y, .z: the weights of a, b, c (CR: w0, w1, w2)
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/triangle.hpp"

#include <optional>

namespace rt {

/// The t strictly inside the interval at which the ray hits the triangle, from either side. Returns
/// nothing if there is none, if the triangle has no area as seen along the ray, or if a coordinate
/// is NaN. Edges and vertices belong to the triangle: two triangles with a shared edge leave no
/// crack. There is no epsilon: the triangle, the direction and its angle to the plane may be of any
/// size in the range of docs/reference/stability.md.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Triangle& triangle,
                                            Interval interval);

/// The barycentric coordinates of a point in the triangle's plane: α a + β b + γ c = point. Their
/// sum is 1, and inside the triangle none is negative. NaN if the triangle has no area.
[[nodiscard]] Vec3 barycentric(const Triangle& triangle, Vec3 point);

/// The unit normal along (b − a) × (c − a), the same at every point.
[[nodiscard]] Vec3 normal(const Triangle& triangle, Vec3 point);

}  // namespace rt
