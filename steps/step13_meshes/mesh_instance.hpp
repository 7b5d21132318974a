// A mesh instance as a shape like the others, built on this stage's functions and the packed
// triangles of common/.
#pragma once

#include "common/geometry/projection.hpp"
#include "common/geometry/ray.hpp"
#include "common/scene/mesh_instance.hpp"

#include <cstdint>
#include <optional>

namespace rt {

/// The closest hit strictly inside the interval; t is that of the ray in the scene.
[[nodiscard]] std::optional<MeshHit> intersect(const Ray& ray, const MeshInstance& instance,
                                               Interval interval);

/// Returns whether the ray hits any triangle strictly inside the interval.
[[nodiscard]] bool occludes(const Ray& ray, const MeshInstance& instance, Interval interval);

/// The number of boxes and triangles that the ray is tested against.
[[nodiscard]] std::int64_t test_count(const Ray& ray, const MeshInstance& instance,
                                      Interval interval, QueryKind query);

/// The hit's point in the scene, computed from its barycentric coordinates, so that it is on the
/// triangle for a ray of any length.
[[nodiscard]] PointWithError snapped_to(const MeshInstance& instance, const MeshHit& hit);

/// The unit normal at the hit; interpolated if the mesh has normals.
[[nodiscard]] Vec3 normal(const MeshInstance& instance, const MeshHit& hit);

/// The unit geometric normal of the triangle.
[[nodiscard]] Vec3 geometric_normal(const MeshInstance& instance, const MeshHit& hit);

}  // namespace rt
