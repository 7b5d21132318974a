// attack: lets another stage's reference answer: the hit of a mesh of one triangle
// ceiling: as a stub
// compiles: no
// message: Your file includes steps/step13_meshes/meshes.hpp
// stage: step05_triangle
#include "steps/step05_triangle/triangle.hpp"

#include "steps/step13_meshes/meshes.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Mesh mesh{.vertices = {triangle.a, triangle.b, triangle.c}, .triangles = {{0, 1, 2}}};
    const auto hit = intersect(ray, mesh, interval);
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
