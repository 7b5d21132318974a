#include "common/scene/surface_points.hpp"

#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Real smallest_size(const MeshInstance& instance) {
    const BoundingBox& box = instance.model->bounds;
    const auto triangles = Real(instance.model->mesh.triangles.size());
    return instance.placement.scale * length(box.max - box.min) / std::sqrt(triangles + 1);
}

Vec3 surface_point(const MeshInstance& instance, Vec2 place) {
    const auto& vertices = instance.model->mesh.vertices;
    if (vertices.empty()) return Vec3(std::numeric_limits<Real>::quiet_NaN());
    const auto i = std::size_t(place.x * Real(vertices.size()));
    return transformed(vertices[std::min(i, vertices.size() - 1)], instance.placement);
}

Real distance(const Plane& a, const Plane& b) {
    const bool parallel = length(cross(unit(a.normal), unit(b.normal))) < 8 * unit_roundoff;
    return parallel ? distance_to_surface(a.point, b) : infinity;
}

Real distance_to_surface(Vec3 /*point*/, const MeshInstance& /*placed*/) {
    return infinity;
}

}  // namespace rt
