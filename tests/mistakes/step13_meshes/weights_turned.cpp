// origin: invented: each weight one vertex further
// caught by: the weights are those of the vertices in their order, and sum to 1 (CR §4.1, M1)
// sentence: Your weights stand one vertex too far: the first is that of triangle[0], and belongs to the area opposite to it.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    auto hit = correct_intersect(ray, mesh, interval);
    if (hit) hit->weights = {hit->weights.z, hit->weights.x, hit->weights.y};
    return hit;
}

}  // namespace rt
