// A placed mesh as a shape among the others, on this stage's functions and the packed triangles of
// common/.
#pragma once

#include "common/placed_mesh.hpp"
#include "common/projection.hpp"
#include "common/ray.hpp"

#include <optional>

namespace rt {

/// The nearest triangle that the ray meets strictly inside the interval; t counts as in the scene.
[[nodiscard]] std::optional<MeshHit> intersect(const Ray& ray, const PlacedMesh& placed,
                                               Interval interval);

/// Whether the ray meets any triangle strictly inside the interval.
[[nodiscard]] bool blocks(const Ray& ray, const PlacedMesh& placed, Interval interval);

/// The hit's point in the scene, from its weights, so that it is on the triangle however far the
/// ray has come.
[[nodiscard]] SurfacePoint projected(const PlacedMesh& placed, const MeshHit& hit);

/// The unit normal at the hit: interpolated, if the mesh has normals.
[[nodiscard]] Vec3 normal(const PlacedMesh& placed, const MeshHit& hit);

/// The unit normal of the triangle itself.
[[nodiscard]] Vec3 side(const PlacedMesh& placed, const MeshHit& hit);

}  // namespace rt
