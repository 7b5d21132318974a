// origin: CR §4.1: the areas not divided by the whole
// caught by: the weights are those of the vertices in their order, and sum to 1 (CR §4.1, M1)
// sentence: Your weights are areas. Divide them by the area of the whole triangle, so that they sum to 1.
#include "tests/mistakes/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return correct_intersect(ray, box, interval);
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    auto hit = correct_intersect(ray, mesh, interval);
    if (!hit) return hit;
    const auto [a, b, c] = triangle_of(mesh, mesh.triangles[hit->triangle]);
    hit->weights *= length(cross(b - a, c - a)) / 2;
    return hit;
}

}  // namespace rt
