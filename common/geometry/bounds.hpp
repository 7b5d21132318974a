// Bounding boxes for the hierarchy and bounding spheres for short lists. Both are padded: no
// rounded intersection test of the stages finds a hit outside them.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/shapes.hpp"

namespace rt {

/// The padded bounding box of a shape, in units of the scene.
[[nodiscard]] Box bounds(const Sphere& sphere);
[[nodiscard]] Box bounds(const Triangle& triangle);
[[nodiscard]] Box bounds(const Square& square);
[[nodiscard]] Box bounds(const Cylinder& cylinder);
[[nodiscard]] Box bounds(const Cone& cone);
[[nodiscard]] Box bounds(const OrientedBox& box);

/// The bounding box of the vertices that triangles use, without padding; empty if there are no
/// triangles.
[[nodiscard]] Box bounds(const Mesh& mesh);

/// The padded bounding sphere of a shape, in units of the scene.
[[nodiscard]] Ball ball_around(const Sphere& sphere);
[[nodiscard]] Ball ball_around(const Triangle& triangle);
[[nodiscard]] Ball ball_around(const Square& square);
[[nodiscard]] Ball ball_around(const Cylinder& cylinder);
[[nodiscard]] Ball ball_around(const Cone& cone);
[[nodiscard]] Ball ball_around(const OrientedBox& box);

/// The bounding sphere of a box that is already padded.
[[nodiscard]] Ball ball_around(const Box& box);

}  // namespace rt
