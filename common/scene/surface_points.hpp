// Points on the surface of a mesh instance, and its size, as each kind of shape has them
// (common/geometry/shape.hpp): for checks of a scene before it is rendered.
#pragma once

#include "common/geometry/plane.hpp"
#include "common/scene/mesh_instance.hpp"

namespace rt {

/// The width of its triangles if all had the same size.
[[nodiscard]] Real smallest_size(const MeshInstance& instance);

/// Any of its vertices.
[[nodiscard]] Vec3 surface_point(const MeshInstance& instance, Vec2 place);

/// Infinite: not computed.
[[nodiscard]] Real distance_to_surface(Vec3 point, const MeshInstance& instance);

/// The distance between planes, infinite unless they are parallel.
[[nodiscard]] Real distance(const Plane& a, const Plane& b);

}  // namespace rt
