// Points on a shape's surface, distances to it, and the shape's size: for checks of a scene before
// it is rendered.
#pragma once

#include "common/geometry/shapes.hpp"
#include "common/scene/mesh_instance.hpp"

namespace rt {

/// The smallest width of a shape, the measure for a displacement.
[[nodiscard]] Real size(const Sphere& sphere);
[[nodiscard]] Real size(const Triangle& triangle);  ///< 0 if it has no area
[[nodiscard]] Real size(const Square& square);
[[nodiscard]] Real size(const Cylinder& cylinder);
[[nodiscard]] Real size(const Cone& cone);
[[nodiscard]] Real size(const OrientedBox& box);
[[nodiscard]] Real size(
    const MeshInstance& instance);  ///< width of its triangles if all had the same size

/// A point of the surface. The parametrization preserves ratios of areas: equal areas of the unit
/// square map to equal areas of the surface.
[[nodiscard]] Vec3 point_of(const Sphere& sphere, Vec2 place);
[[nodiscard]] Vec3 point_of(const Triangle& triangle, Vec2 place);
[[nodiscard]] Vec3 point_of(const Square& square, Vec2 place);
[[nodiscard]] Vec3 point_of(const Cylinder& cylinder, Vec2 place);
[[nodiscard]] Vec3 point_of(const Cone& cone, Vec2 place);
[[nodiscard]] Vec3 point_of(const OrientedBox& box, Vec2 place);        ///< a third for each axis
[[nodiscard]] Vec3 point_of(const MeshInstance& instance, Vec2 place);  ///< any of its vertices

/// The distance from the point to the surface; between planes, infinite unless they are parallel.
[[nodiscard]] Real distance(Vec3 point, const Sphere& sphere);
[[nodiscard]] Real distance(Vec3 point, const Plane& plane);
[[nodiscard]] Real distance(const Plane& a, const Plane& b);
[[nodiscard]] Real distance(Vec3 point, const Triangle& triangle);
[[nodiscard]] Real distance(Vec3 point, const Square& square);
[[nodiscard]] Real distance(Vec3 point, const Cylinder& cylinder);
[[nodiscard]] Real distance(Vec3 point, const Cone& cone);
[[nodiscard]] Real distance(Vec3 point, const OrientedBox& box);
[[nodiscard]] Real distance(Vec3 point, const MeshInstance& instance);  ///< infinite: not computed

}  // namespace rt
