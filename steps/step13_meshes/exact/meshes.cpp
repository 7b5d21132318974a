// Stage 13 for `--precision exact`: the reference, and the exact intersection with a mesh instance
// for the ray in object space.
#include "steps/step13_meshes/reference/meshes.cpp"

#include "common/exact/leader.hpp"

namespace rt {

std::optional<ExactRoot> exact_root(const Ray& ray, const MeshInstance& instance,
                                    std::uint32_t triangle, Interval interval) {
    const Mesh& mesh = instance.model->mesh;
    return exact_root(to_object_space(ray, instance.placement),
                      triangle_of(mesh, mesh.triangles[triangle]), interval);
}

}  // namespace rt
