// Bounding boxes of meshes for the hierarchy, and bounding spheres of boxes. The file of each kind
// of shape defines `bounds(shape)` and `bounding_sphere(shape)`, both padded: no rounded
// intersection test of the stages finds a hit outside them.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/mesh.hpp"

namespace rt {

/// The bounding box of the vertices that triangles use, without padding; empty if there are no
/// triangles.
[[nodiscard]] BoundingBox bounds(const Mesh& mesh);

/// The bounding sphere of a box that is already padded.
[[nodiscard]] BoundingSphere bounding_sphere(const BoundingBox& box);

}  // namespace rt
