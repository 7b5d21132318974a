// origin: a student's: an epsilon on the area
// caught by: small triangles are met: there is no epsilon on their area (contract)
// sentence: You leave out small triangles: a mesh may be of any size. Only a triangle without any area is missed.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    Mesh large{.vertices = mesh.vertices, .normals = mesh.normals, .triangles = {}};
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = triangle_of(mesh, mesh.triangles[i]);
        if (length(cross(b - a, c - a)) < Real(1e-6)) continue;
        large.triangles.push_back(mesh.triangles[i]);
        numbers.push_back(i);
    }
    std::optional<MeshHit> hit = correct_intersect(ray, large, interval);
    if (hit) hit->triangle = numbers[hit->triangle];
    return hit;
}

}  // namespace rt
