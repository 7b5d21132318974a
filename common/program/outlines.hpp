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

// The outlines of the shapes.
[[nodiscard]] Segments outline(const Sphere& sphere);
[[nodiscard]] Segments outline(const Triangle& triangle);
[[nodiscard]] Segments outline(const Square& square);
[[nodiscard]] Segments outline(const Cylinder& cylinder);
[[nodiscard]] Segments outline(const Cone& cone);
[[nodiscard]] Segments outline(const OrientedBox& box);

/// A grid of lines on the plane, inside the box.
[[nodiscard]] Segments outline(const Plane& plane, const BoundingBox& box);

/// The edges of a mesh, or, if it has many, its cuts by a few planes.
[[nodiscard]] Segments outline(const MeshInstance& instance);

}  // namespace rt
