// origin: invented: a triangle has three unsigned short
// caught by: a mesh's triangles have the vertices that they name, counted from 0 (CR §4.2)
// sentence: You keep indices of vertices in 16 bits: a mesh may have more than 65536 vertices.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = [&] {
            auto corners = mesh.triangles[i];
            for (auto& corner : corners) corner = std::uint16_t(corner);
            return triangle_of(mesh, corners);
        }();
        const auto t = intersect(ray, triangle, interval);
        if (!t) continue;
        interval.max = *t;
        nearest = MeshHit{.t = *t, .triangle = i};
        nearest->weights = barycentric(triangle, at(ray, *t));
    }
    return nearest;
}

}  // namespace rt
