// Stage 13: meshes and boxes (CR §4.2; M1, boxes and change of coordinates; HAI, transforms; CR
// §6).
//
//   documents          here
//   pmin, pmax (M1)    box.min, box.max
//   c, u, v, w (M1)    box.center, box.half_size.x · box.basis.x, and so on for y and z
//   t_min, t_max (M1)  the interval in which the ray is inside
//   vertices, triangles (CR)   mesh.vertices, mesh.triangles
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/transform.hpp"

#include <array>
#include <optional>

namespace rt {

/// The part of the interval in which the ray is inside the box or on its faces: from its entry into
/// the last of the three slabs to its exit from the first. Returns nothing if there is none, or if
/// a coordinate is NaN. A ray that runs in a face, where 0 · ∞ arises, is inside.
[[nodiscard]] std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box,
                                              Interval interval);

/// The smallest t strictly inside the interval at which the ray hits a face of the box, from
/// outside or from inside. Returns nothing if there is none, or if a coordinate is NaN.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const OrientedBox& box,
                                            Interval interval);

/// The unit normal of the face that contains the point, or of the nearest face.
[[nodiscard]] Vec3 normal(const OrientedBox& box, Vec3 point);

/// The ray transformed to the object space of a mesh with this placement. Each of its points keeps
/// its t, so the direction is not scaled to unit length.
[[nodiscard]] Ray to_object_space(const Ray& ray, const Transform& placement);

/// The closest hit among the mesh's triangles strictly inside the interval, with its barycentric
/// coordinates; nothing if there is none. Each triangle is hit where stage 5's intersect hits it,
/// so that no ray is lost at an edge that two triangles share.
[[nodiscard]] std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval);

/// The interpolation of three unit normals with the given weights, scaled to unit length.
[[nodiscard]] Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights);

}  // namespace rt
