#include "scenes/meshes/polygons.hpp"

#include "common/mesh_file/triangulate.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rt {

namespace {

/// On the ellipse, corner k of n; the first is half a step on, so that a side faces `across`.
glm::dvec3 point_on(const Ellipse& ellipse, int k, int n) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / n;
    return ellipse.center + std::cos(angle) * ellipse.across + std::sin(angle) * ellipse.along;
}

/// Quadrilaterals between one row of n vertices and another, both closed.
void add_band(Polygons& polygons, int row, int other_row, int n) {
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        polygons.faces.push_back({row + k, row + next, other_row + next, other_row + k});
    }
}

}  // namespace

void append(Polygons& polygons, const Polygons& more) {
    const auto offset = static_cast<int>(polygons.vertices.size());
    polygons.vertices.insert(polygons.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (std::vector<int> face : more.faces) {
        for (int& corner : face) corner += offset;
        polygons.faces.push_back(std::move(face));
    }
}

Polygons mirrored(Polygons polygons) {
    for (glm::dvec3& v : polygons.vertices) v.x = -v.x;
    for (std::vector<int>& face : polygons.faces) std::reverse(face.begin(), face.end());
    return polygons;
}

Polygons box(glm::dvec3 center, glm::dvec3 half_size) {
    Polygons result;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        result.vertices.push_back(center + corner * half_size);
    }
    result.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                    {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    return result;
}

Polygons loft(const std::vector<Ellipse>& ellipses, int corners) {
    Polygons result;
    for (const Ellipse& ellipse : ellipses) {
        for (int k = 0; k < corners; ++k) result.vertices.push_back(point_on(ellipse, k, corners));
    }
    const auto last = static_cast<int>(ellipses.size() - 1) * corners;
    for (int row = 0; row < last; row += corners) add_band(result, row, row + corners, corners);
    std::vector<int> bottom;
    std::vector<int> top;
    for (int k = 0; k < corners; ++k) {
        bottom.push_back(corners - 1 - k);
        top.push_back(last + k);
    }
    result.faces.push_back(bottom);
    result.faces.push_back(top);
    return result;
}

Polygons ring(const Ellipse& ellipse, double thickness, int corners) {
    const glm::dvec3 axis =
        thickness / 2 * glm::normalize(glm::cross(ellipse.across, ellipse.along));
    Polygons result;
    // Inside below, outside below, outside above, inside above.
    for (const auto& [outwards, upwards] :
         {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
        for (int k = 0; k < corners; ++k) {
            const glm::dvec3 point = point_on(ellipse, k, corners);
            const glm::dvec3 out = glm::normalize(point - ellipse.center) * (thickness / 2);
            result.vertices.push_back(point + double(outwards) * out + double(upwards) * axis);
        }
    }
    for (int row = 0; row < 4; ++row) {
        add_band(result, row * corners, (row + 1) % 4 * corners, corners);
    }
    return result;
}

Polygons cut_up(Polygons polygons) {
    std::vector<std::vector<int>> triangles;
    for (const std::vector<int>& face : polygons.faces) {
        std::vector<glm::dvec3> corners;
        for (const int corner : face) {
            corners.push_back(polygons.vertices[static_cast<std::size_t>(corner)]);
        }
        for (const auto& [a, b, c] : triangulate(corners)) {
            triangles.push_back({face[a], face[b], face[c]});
        }
    }
    polygons.faces = std::move(triangles);
    return polygons;
}

}  // namespace rt
