// Line segments that show a shape from any side.
#pragma once

#include "common/scene/scene.hpp"

#include <vector>

namespace rt {
inline namespace RT_PRECISION {

struct Segment {
    Vec3 from;
    Vec3 to;
};

using Segments = std::vector<Segment>;

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

// The outlines of the shapes; a plane's is a grid of lines inside of the box.
[[nodiscard]] Segments outline(const Sphere& sphere, const BoundingBox& box);
[[nodiscard]] Segments outline(const Plane& plane, const BoundingBox& box);
[[nodiscard]] Segments outline(const Triangle& triangle, const BoundingBox& box);
[[nodiscard]] Segments outline(const Square& square, const BoundingBox& box);
[[nodiscard]] Segments outline(const Cylinder& cylinder, const BoundingBox& box);
[[nodiscard]] Segments outline(const Cone& cone, const BoundingBox& box);
[[nodiscard]] Segments outline(const OrientedBox& shape, const BoundingBox& box);

/// The edges of a mesh, or, if it has many, its cuts by a few planes.
[[nodiscard]] Segments outline(const MeshInstance& instance, const BoundingBox& box);

}  // namespace rt
