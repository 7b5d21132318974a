// Bounding boxes for the hierarchy and bounding spheres for short lists. Both are padded: no
// rounded intersection test of the stages finds a hit outside them.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/shapes.hpp"

namespace rt {

/// The padded bounding box of a shape, in units of the scene.
[[nodiscard]] BoundingBox bounds(const Sphere& sphere);
[[nodiscard]] BoundingBox bounds(const Triangle& triangle);
[[nodiscard]] BoundingBox bounds(const Square& square);
[[nodiscard]] BoundingBox bounds(const Cylinder& cylinder);
[[nodiscard]] BoundingBox bounds(const Cone& cone);
[[nodiscard]] BoundingBox bounds(const OrientedBox& box);

/// The bounding box of the vertices that triangles use, without padding; empty if there are no
/// triangles.
[[nodiscard]] BoundingBox bounds(const Mesh& mesh);

/// The padded bounding sphere of a shape, in units of the scene.
[[nodiscard]] BoundingSphere bounding_sphere(const Sphere& sphere);
[[nodiscard]] BoundingSphere bounding_sphere(const Triangle& triangle);
[[nodiscard]] BoundingSphere bounding_sphere(const Square& square);
[[nodiscard]] BoundingSphere bounding_sphere(const Cylinder& cylinder);
[[nodiscard]] BoundingSphere bounding_sphere(const Cone& cone);
[[nodiscard]] BoundingSphere bounding_sphere(const OrientedBox& box);

/// The bounding sphere of a box that is already padded.
[[nodiscard]] BoundingSphere bounding_sphere(const BoundingBox& box);

}  // namespace rt
