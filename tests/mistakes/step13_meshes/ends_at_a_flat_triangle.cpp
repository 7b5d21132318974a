// origin: invented: break in place of continue
// caught by: the closest triangle is hit, for any order of the triangles (M1, CR §4.2)
// sentence: Your loop ends at a triangle without area, whose weights are no numbers. Such a triangle is missed: go on with the next one.
#include "tests/mistakes/step13_meshes/all_but_mesh.hpp"

namespace rt {

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    Mesh until_flat = mesh;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle triangle = triangle_of(mesh, mesh.triangles[i]);
        if (!std::isnan(barycentric(triangle, triangle.a).x)) continue;
        until_flat.triangles.resize(i);
        break;
    }
    return correct_intersect(ray, until_flat, interval);
}

}  // namespace rt
