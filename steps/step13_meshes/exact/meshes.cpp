// Stage 13 for `--precision exact`: the reference, and the exact intersection with a mesh instance
// for the ray in object space.
#include "steps/step13_meshes/reference/meshes.cpp"

#include "common/exact/leader.hpp"

namespace rt {

std::optional<ExactRoot> exact_root(const Ray& ray, const PlacedMesh& placed,
                                    std::uint32_t triangle, Interval interval) {
    const Mesh& mesh = placed.model->mesh;
    return exact_root(into_frame(ray, placed.placement),
                      triangle_of(mesh, mesh.triangles[triangle]), interval);
}

}  // namespace rt
