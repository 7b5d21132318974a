// Stage 13: meshes and boxes (CR §4.2; M1, boxes and change of frame; HAI, transforms; CR §6).
//
//   documents          here
//   pmin, pmax (M1)    box.min, box.max
//   c, u, v, w (M1)    box.center, box.half_size.x · box.basis.x, and so on for y and z
//   t_min, t_max (M1)  the interval in which the ray is inside
//   vertices, triangles (CR)   mesh.vertices, mesh.triangles
#pragma once

#include "common/box.hpp"
#include "common/mesh.hpp"
#include "common/motion.hpp"
#include "common/ray.hpp"

#include <array>
#include <optional>

namespace rt {

/// The part of the interval in which the ray is inside the box or on its faces: from where it
/// enters all three slabs to where it leaves the first; nothing if there is none, or if a
/// coordinate is NaN. A ray along a face, 0 · ∞, is inside.
[[nodiscard]] std::optional<Interval> overlap(const Ray& ray, const Box& box, Interval interval);

/// The smallest t strictly inside the interval at which the ray meets a face of the box, from
/// outside or from inside; nothing if there is none, or if a coordinate is NaN.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const OrientedBox& box,
                                            Interval interval);

/// The unit normal at a point of the box: of the face that the point is on, or nearest to.
[[nodiscard]] Vec3 normal(const OrientedBox& box, Vec3 point);

/// The ray as the mesh sees it that the placement has moved: every point keeps its t, so the
/// direction is not made unit length.
[[nodiscard]] Ray into_frame(const Ray& ray, const Motion& placement);

/// The nearest of all the mesh's triangles that the ray meets strictly inside the interval, with
/// the weights of its vertices; nothing if it meets none. Stage 5 knows how to meet one.
[[nodiscard]] std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval);

/// The normal between three of unit length, by the weights; of unit length again.
[[nodiscard]] Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights);

}  // namespace rt
