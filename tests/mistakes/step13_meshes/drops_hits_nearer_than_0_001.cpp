// origin: CR §4.2 as printed, erratum 31
// caught by: a triangle is met however near it is (erratum 31, CR §4.2)
// sentence: You drop hits at t ≤ 0.001, as CR §4.2 prints it. That distance depends on the scene's unit and on d: the only condition is t > 0, and the ray starts off the surface.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = triangle_of(mesh, mesh.triangles[i]);
        const auto t = intersect(ray, triangle, interval);
        if (!t || *t <= Real(0.001)) continue;
        interval.max = *t;
        nearest = MeshHit{.t = *t, .triangle = i};
        nearest->weights = barycentric(triangle, at(ray, *t));
    }
    return nearest;
}

}  // namespace rt
