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

/// The outline of a kind of shape without one below: curves along both coordinates of its surface.
template <BoundedKindOfShape Shape>
[[nodiscard]] Segments outline(const Shape& shape) {
    constexpr int curves = 8;
    constexpr int pieces = 32;
    Segments segments;
    for (int curve = 0; curve < curves; ++curve)
        for (int piece = 0; piece < pieces; ++piece) {
            const Vec2 from(Real(curve) / curves, Real(piece) / pieces);
            const Vec2 to(from.x, Real(piece + 1) / pieces);
            segments.push_back({surface_point(shape, from), surface_point(shape, to)});
            segments.push_back(
                {surface_point(shape, {from.y, from.x}), surface_point(shape, {to.y, to.x})});
        }
    return segments;
}

// The outlines of the others.
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
