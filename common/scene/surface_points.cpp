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

std::vector<Vec3> outline(const Sphere& sphere, Vec3 eye, int count) {
    const Vec3 way = sphere.center - eye;
    const Real part = sphere.radius * sphere.radius / dot(way, way);
    const Real radius = sphere.radius * std::sqrt(1 - part);
    std::vector<Vec3> points;
    for (int i = 0; i < count && part < 1; ++i)
        points.push_back(sphere.center - part * way +
                         radius * geometry::perpendicular(unit(way), Real(i) / Real(count)));
    return points;
}

std::vector<Vec3> outline(const OrientedBox& box, Vec3 /*eye*/, int /*count*/) {
    const auto& [x, y, z] = box.basis;
    std::vector<Vec3> points;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto side = [corner](unsigned axis) { return Real(int(corner >> axis & 1) * 2 - 1); };
        const Vec3 in_box = box.half_size * Vec3(side(0), side(1), side(2));
        points.push_back(box.center + in_box.x * x + in_box.y * y + in_box.z * z);
    }
    return points;
}

Real distance(const Plane& a, const Plane& b) {
    const bool parallel = length(cross(unit(a.normal), unit(b.normal))) < 8 * unit_roundoff;
    return parallel ? distance_to_surface(a.point, b) : infinity;
}

Real distance_to_surface(Vec3 /*point*/, const MeshInstance& /*placed*/) {
    return infinity;
}

}  // namespace rt
