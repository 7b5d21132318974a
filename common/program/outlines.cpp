#include "common/program/outlines.hpp"

#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace rt {

namespace {

constexpr int corners_of_circle = 32;
constexpr int lines_of_tube = 8;
constexpr int lines_of_grid = 10;
constexpr std::size_t most_edges = 400;  ///< triangles of a mesh that is drawn by its edges
constexpr int cuts_of_mesh = 6;          ///< along each axis

void add_circle(Segments& segments, Vec3 center, Vec3 axis, Real radius) {
    const auto corner = [&](int i) {
        return center + radius * geometry::perpendicular(
                                     axis, Real(i % corners_of_circle) / Real(corners_of_circle));
    };
    for (int i = 0; i < corners_of_circle; ++i) segments.push_back({corner(i), corner(i + 1)});
}

void add_polygon(Segments& segments, const auto& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
}

/// The part of a line that is inside of the box.
std::optional<Segment> inside(Vec3 point, Vec3 along, const BoundingBox& box) {
    Real from = -infinity;
    Real to = infinity;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (along[i] == 0 && !(box.min[i] <= point[i] && point[i] <= box.max[i]))
            return std::nullopt;
        if (along[i] == 0) continue;
        const Real a = (box.min[i] - point[i]) / along[i];
        const Real b = (box.max[i] - point[i]) / along[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (!(from < to && to - from < infinity)) return std::nullopt;
    return Segment{.from = point + from * along, .to = point + to * along};
}

/// The segment in which the plane axis = level cuts the triangle.
std::optional<Segment> cut(const std::array<Vec3, 3>& triangle, glm::length_t axis, Real level) {
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 && count < 2; ++i) {
        const Vec3& a = triangle[i];
        const Vec3& b = triangle[(i + 1) % 3];
        if ((a[axis] < level) == (b[axis] < level)) continue;
        ends[count++] = a + (level - a[axis]) / (b[axis] - a[axis]) * (b - a);
    }
    if (count < 2) return std::nullopt;
    return Segment{.from = ends[0], .to = ends[1]};
}

}  // namespace

Segments outline(const Sphere& sphere) {
    Segments segments;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        add_circle(segments, sphere.center, axis, sphere.radius);
    return segments;
}

Segments outline(const Plane& plane, const BoundingBox& box) {
    const Vec3 normal = unit(plane.normal);
    const Vec3 middle = geometry::onto_plane((box.min + box.max) / Real(2), plane.point, normal);
    const Vec3 across = geometry::perpendicular(normal, 0);
    const std::array<Vec3, 2> axes = {across, cross(normal, across)};
    const Real reach = length(box.max - box.min) / 2;
    Segments segments;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (int i = -lines_of_grid; i <= lines_of_grid; ++i) {
            const Vec3 start = middle + reach * Real(i) / Real(lines_of_grid) * axes[1 - axis];
            if (const auto line = inside(start, axes[axis], box)) segments.push_back(*line);
        }
    return segments;
}

Segments outline(const Triangle& triangle) {
    Segments segments;
    add_polygon(segments, std::array{triangle.a, triangle.b, triangle.c});
    return segments;
}

Segments outline(const Square& square) {
    const Vec3 x = square.side / 2 * square.basis.x;
    const Vec3 y = square.side / 2 * square.basis.y;
    const Vec3& c = square.center;
    Segments segments;
    add_polygon(segments, std::array{c - x - y, c + x - y, c + x + y, c - x + y});
    return segments;
}

Segments outline(const Cylinder& cylinder) {
    const auto& [center, axis, radius, height] = cylinder;
    const Vec3 half = height / 2 * axis;
    Segments segments;
    add_circle(segments, center - half, axis, radius);
    add_circle(segments, center + half, axis, radius);
    for (int i = 0; i < lines_of_tube; ++i) {
        const Vec3 side = radius * geometry::perpendicular(axis, Real(i) / Real(lines_of_tube));
        segments.push_back({center + side - half, center + side + half});
    }
    return segments;
}

Segments outline(const Cone& cone) {
    const auto& [apex, axis, radius, height] = cone;
    const Vec3 rim = apex + height * axis;
    Segments segments;
    add_circle(segments, rim, axis, radius);
    for (int i = 0; i < lines_of_tube; ++i)
        segments.push_back(
            {apex, rim + radius * geometry::perpendicular(axis, Real(i) / Real(lines_of_tube))});
    return segments;
}

Segments outline(const OrientedBox& box) {
    const auto& [center, basis, half] = box;
    const std::array axes = {half.x * basis.x, half.y * basis.y, half.z * basis.z};
    Segments segments;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Real u : {Real(-1), Real(1)})
            for (const Real v : {Real(-1), Real(1)}) {
                const Vec3 middle = center + u * axes[(axis + 1) % 3] + v * axes[(axis + 2) % 3];
                segments.push_back({middle - axes[axis], middle + axes[axis]});
            }
    return segments;
}

Segments outline(const MeshInstance& instance) {
    const Mesh& mesh = instance.model->mesh;
    const BoundingBox& bounds = instance.model->bounds;
    Segments segments;
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::array triangle = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
        if (mesh.triangles.size() <= most_edges) {
            add_polygon(segments, triangle);
            continue;
        }
        for (glm::length_t axis = 0; axis < 3; ++axis)
            for (int i = 0; i < cuts_of_mesh; ++i) {
                const Real share = (Real(i) + Real(0.5)) / Real(cuts_of_mesh);
                const Real level = bounds.min[axis] + share * (bounds.max[axis] - bounds.min[axis]);
                if (const auto line = cut(triangle, axis, level)) segments.push_back(*line);
            }
    }
    for (Segment& segment : segments)
        segment = {.from = transformed(segment.from, instance.placement),
                   .to = transformed(segment.to, instance.placement)};
    return segments;
}

}  // namespace rt
