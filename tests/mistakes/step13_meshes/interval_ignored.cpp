// origin: invented: t > 0 only
// caught by: only triangles strictly inside the interval are met (contract)
// sentence: You test t > 0 only. Only hits strictly inside the interval count, between its min and its max.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    interval = {};
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = triangle_of(mesh, mesh.triangles[i]);
        const auto t = intersect(ray, triangle, interval);
        if (!t) continue;
        interval.max = *t;
        nearest = MeshHit{.t = *t, .triangle = i};
        nearest->weights = barycentric(triangle, at(ray, *t));
    }
    return nearest;
}

}  // namespace rt
