// attack: lets the packed meshes of common/ intersect the triangle
// ceiling: as a stub
// stage: step05_triangle
// compiles: no
// message: Your file includes common/bvh/mesh_bvh.hpp
#include "steps/step05_triangle/triangle.hpp"

#include "common/bvh/mesh_bvh.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const MeshBvh packed(
        Mesh{.vertices = {triangle.a, triangle.b, triangle.c}, .triangles = {{0, 1, 2}}});
    const auto hit = packed.nearest(ray, interval);
    if (!hit) return std::nullopt;
    return hit->t;
}

Vec3 barycentric(const Triangle&, Vec3) {
    return Vec3(0);
}

Vec3 normal(const Triangle&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
