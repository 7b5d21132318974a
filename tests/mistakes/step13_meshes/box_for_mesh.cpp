// origin: course/mistakes.md
// caught by: a ray through the mesh's box misses where no triangle is (CR §4.2)
// sentence: You return the hit with the box around the mesh. The box only shows that the triangles must be tested.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    BoundingBox box;
    for (const Vec3& vertex : mesh.vertices) box = merged(box, vertex);
    if (mesh.triangles.empty()) return std::nullopt;
    const auto inside = overlap(ray, box, interval);
    if (!inside) return std::nullopt;
    MeshHit hit{.t = interval.contains(inside->min) ? inside->min : inside->max};
    hit.weights = barycentric(triangle_of(mesh, mesh.triangles[0]), at(ray, hit.t));
    return hit;
}

}  // namespace rt
