#include "common/geometry/mesh_normals.hpp"

#include "common/system/huge_pages.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace rt {

namespace {

/// Double in either precision: squares of a float stay in the range of double.
using Wide = glm::dvec3;

}  // namespace

std::vector<Vec3> smooth_normals(const Mesh& mesh) {
    std::vector<Wide> sums;
    reserve_huge(sums, mesh.vertices.size());
    sums.resize(mesh.vertices.size(), Wide(0));
    for (const auto& [i, j, k] : mesh.triangles) {
        const Wide a = mesh.vertices[i];
        const Wide ab = Wide(mesh.vertices[j]) - a;
        const Wide ac = Wide(mesh.vertices[k]) - a;
        const Wide normal = glm::cross(ab, ac);
        const double length = glm::length(normal);
        if (!(length > 0)) continue;
        // Twice the triangle's area is the length of the cross product of any two of its sides. An
        // acos of their dot product would lose half the digits of a small angle.
        const double at_a = std::atan2(length, glm::dot(ab, ac));
        const double at_b = std::atan2(length, glm::dot(ab, ab - ac));
        const Wide direction = normal / length;
        sums[i] += at_a * direction;
        sums[j] += at_b * direction;
        sums[k] += (std::numbers::pi - at_a - at_b) * direction;
    }
    std::vector<Vec3> normals;
    reserve_huge(normals, sums.size());
    for (const Wide& sum : sums) {
        const double length = glm::length(sum);
        normals.push_back(length > 0 ? Vec3(sum / length) : Vec3(0, 0, 1));
    }
    return normals;
}

}  // namespace rt
