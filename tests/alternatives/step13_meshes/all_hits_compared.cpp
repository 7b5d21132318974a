// right: CR §4.2's loop, t compared at the end, and CR §4.1's areas
#include "tests/alternatives/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#define interpolated_normal(...) correct_interpolated_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect
#undef interpolated_normal

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return correct_intersect(ray, box, interval);
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    MeshHit closest{.t = infinity};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [i0, i1, i2] = mesh.triangles[i];
        const Vec3 c0 = mesh.vertices[i0];
        const Vec3 c1 = mesh.vertices[i1];
        const Vec3 c2 = mesh.vertices[i2];
        const auto t = intersect(ray, Triangle{.a = c0, .b = c1, .c = c2}, interval);
        if (!t || *t >= closest.t) continue;
        const Vec3 p = ray.origin + *t * ray.direction;
        const Real area0 = length(cross(c1 - p, c2 - p));
        const Real area1 = length(cross(c2 - p, c0 - p));
        const Real area2 = length(cross(c0 - p, c1 - p));
        const Real sum = area0 + area1 + area2;
        closest = {
            .t = *t, .triangle = std::uint32_t(i), .weights = Vec3(area0, area1, area2) / sum};
    }
    if (closest.t == infinity) return std::nullopt;
    return closest;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    const Vec3 a = weights[0] * normals[0];
    const Vec3 b = weights[1] * normals[1];
    const Vec3 c = weights[2] * normals[2];
    return normalize(a + b + c);
}

}  // namespace rt
