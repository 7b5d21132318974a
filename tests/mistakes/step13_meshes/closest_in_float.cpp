// origin: invented: a variable of the wrong type
// caught by: the closest triangle is hit, for any order of the triangles (M1, CR §4.2)
// sentence: You keep the smallest t in a float: of two triangles that are almost as near, the first is hit. Keep it in a Real.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    float smallest = std::numeric_limits<float>::infinity();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = triangle_of(mesh, mesh.triangles[i]);
        const auto t = intersect(ray, triangle, interval);
        if (!t || float(*t) >= smallest) continue;
        smallest = float(*t);
        nearest = MeshHit{.t = *t, .triangle = i};
        nearest->weights = barycentric(triangle, at(ray, *t));
    }
    return nearest;
}

}  // namespace rt
