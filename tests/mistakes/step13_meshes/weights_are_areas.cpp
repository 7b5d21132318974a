// origin: CR §4.1: the areas not divided by the whole
// caught by: the weights are those of the vertices in their order, and sum to 1 (CR §4.1, M1)
// sentence: Your weights are areas. Divide them by the area of the whole triangle, so that they sum to 1.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    auto hit = correct_intersect(ray, mesh, interval);
    if (!hit) return hit;
    const auto [a, b, c] = triangle_of(mesh, mesh.triangles[hit->triangle]);
    hit->weights *= length(cross(b - a, c - a)) / 2;
    return hit;
}

}  // namespace rt
