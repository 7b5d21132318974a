// origin: CR §4.2 as printed, erratum 28
// caught by: the vertices are where they are, not ten thousand times nearer (erratum 28, CR §4.2)
// sentence: You multiply the vertices by 0.0001, as CR §4.2 prints it. They are where they are.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = [&] {
            const Triangle whole = triangle_of(mesh, mesh.triangles[i]);
            const Real scale = Real(0.0001);
            return Triangle{.a = scale * whole.a, .b = scale * whole.b, .c = scale * whole.c};
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
