#include "steps/step13_meshes/mesh_instance.hpp"

#include "common/math/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

namespace {

Triangle triangle_of(const MeshInstance& instance, const MeshHit& hit) {
    const Mesh& mesh = instance.model->mesh;
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    return transformed(
        Triangle{.a = mesh.vertices[a], .b = mesh.vertices[b], .c = mesh.vertices[c]},
        instance.placement);
}

}  // namespace

std::optional<MeshHit> intersect(const Ray& ray, const MeshInstance& instance, Interval interval) {
    const auto& [mesh, bounds, packed] = *instance.model;
    const Ray in_frame = to_object_space(ray, instance.placement);
    if (packed) return packed->nearest(in_frame, interval);
    if (!overlap(in_frame, bounds, interval)) return std::nullopt;
    return intersect(in_frame, mesh, interval);
}

bool occludes(const Ray& ray, const MeshInstance& instance, Interval interval) {
    const std::optional<MeshBvh>& packed = instance.model->packed;
    if (!packed) return intersect(ray, instance, interval).has_value();
    return packed->occludes(to_object_space(ray, instance.placement), interval);
}

std::int64_t test_count(const Ray& ray, const MeshInstance& instance, Interval interval,
                        QueryKind query) {
    const auto& [mesh, bounds, packed] = *instance.model;
    const Ray in_frame = to_object_space(ray, instance.placement);
    if (packed) return packed->test_count(in_frame, interval, query);
    const bool reaches = overlap(in_frame, bounds, interval).has_value();
    return 1 + (reaches ? std::int64_t(mesh.triangles.size()) : 0);
}

PointWithError snapped_to(const MeshInstance& instance, const MeshHit& hit) {
    const Triangle triangle = triangle_of(instance, hit);
    const Vec3& w = hit.weights;
    auto [point, error] =
        snapped_to(triangle, w.x * triangle.a + w.y * triangle.b + w.z * triangle.c);
    // In object space a mesh may be far from the origin, and its triangles are intersected there.
    const auto& [min, max] = instance.model->bounds;
    const Real in_frame = largest_component(glm::max(abs(min), abs(max)));
    const Transform& placement = instance.placement;
    const Real largest = placement.scale * in_frame + largest_component(placement.translation);
    return {.point = point, .error = glm::max(error, projection_error(largest))};
}

Vec3 normal(const MeshInstance& instance, const MeshHit& hit) {
    const Mesh& mesh = instance.model->mesh;
    if (mesh.normals.empty()) return geometric_normal(instance, hit);
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    return rotated(
        interpolated_normal({mesh.normals[a], mesh.normals[b], mesh.normals[c]}, hit.weights),
        instance.placement);
}

Vec3 geometric_normal(const MeshInstance& instance, const MeshHit& hit) {
    const Triangle triangle = triangle_of(instance, hit);
    const Vec3 of_corners = normal(triangle, triangle.a);
    return is_reflection(instance.placement) ? -of_corners : of_corners;
}

}  // namespace rt
