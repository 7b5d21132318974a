// origin: HAI's squares: N · D < 0
// caught by: from inside, a mesh is met from its inside (CR §4.2)
// sentence: You leave out triangles that face away. From inside a mesh one sees its inside, and the shadow of an open one would have holes.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = triangle_of(mesh, mesh.triangles[i]);
        const auto t = intersect(ray, triangle, interval);
        if (!t || dot(ray.direction, normal(triangle, triangle.a)) > 0) continue;
        interval.max = *t;
        nearest = MeshHit{.t = *t, .triangle = i};
        nearest->weights = barycentric(triangle, at(ray, *t));
    }
    return nearest;
}

}  // namespace rt
