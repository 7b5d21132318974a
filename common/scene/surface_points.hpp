// Points on the surface of a mesh instance, and its size, as each kind of shape has them
// (common/geometry/shape.hpp), and outlines of shapes: for checks of a scene before it is rendered.
#pragma once

#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/sphere.hpp"
#include "common/scene/mesh_instance.hpp"

#include <vector>

namespace rt {

/// The width of its triangles if all had the same size.
[[nodiscard]] Real smallest_size(const MeshInstance& instance);

/// Any of its vertices.
[[nodiscard]] Vec3 surface_point(const MeshInstance& instance, Vec2 place);

/// Infinite: not computed.
[[nodiscard]] Real distance_to_surface(Vec3 point, const MeshInstance& instance);

/// The distance between planes, infinite unless they are parallel.
[[nodiscard]] Real distance(const Plane& a, const Plane& b);

/// Points whose convex hull is seen from `eye` like the shape, with `count` of them in place of a
/// circle. A point with an odd index is on a line of the surface with the one before it.
[[nodiscard]] std::vector<Vec3> outline(const Sphere& sphere, Vec3 eye, int count);
[[nodiscard]] std::vector<Vec3> outline(const OrientedBox& box, Vec3 eye, int count);

/// The same for the others: the boundary of the unit square maps to the outline of a flat shape,
/// and to the rims of a round one.
template <class Shape>
[[nodiscard]] std::vector<Vec3> outline(const Shape& shape, Vec3 /*eye*/, int count) {
    constexpr bool is_round = requires {
        shape.radius;
    };
    const int last = is_round ? count : 1;
    std::vector<Vec3> points;
    for (int i = 0; i <= last; ++i)
        for (const Real y : {Real(0), Real(1)})
            points.push_back(surface_point(shape, {Real(i) / Real(last), y}));
    return points;
}

}  // namespace rt
