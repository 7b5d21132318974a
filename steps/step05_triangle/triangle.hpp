// Stage 5: triangles (MRT §5 by half-planes; M1 by barycentric coordinates; CR §4.1 by areas).
//
//   documents        here
//   a, b, c          triangle.a, triangle.b, triangle.c (CR: c0, c1, c2)
//   n                (b − a) × (c − a)
//   α, β, γ          barycentric(…).x, .y, .z: the weights of a, b, c (CR: w0, w1, w2)
#pragma once

#include "common/ray.hpp"
#include "common/shapes.hpp"

#include <optional>

namespace rt {

/// The t strictly inside the interval at which the ray meets the triangle, from either side;
/// nothing if there is none, if the triangle has no area as the ray sees it, or if a coordinate is
/// NaN. Edges and vertices belong to the triangle: two that share an edge leave no crack.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Triangle& triangle,
                                            Interval interval);

/// The weights of a, b and c that give a point of the triangle's plane: α a + β b + γ c = point.
/// They sum to 1, and none is negative inside. NaN if the triangle has no area.
[[nodiscard]] Vec3 barycentric(const Triangle& triangle, Vec3 point);

/// The unit normal along (b − a) × (c − a), the same at every point.
[[nodiscard]] Vec3 normal(const Triangle& triangle, Vec3 point);

}  // namespace rt
