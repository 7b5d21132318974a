#include "steps/step13_meshes/mesh_instance.hpp"

#include "common/math/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

namespace {

Triangle triangle_of(const PlacedMesh& placed, const MeshHit& hit) {
    const Mesh& mesh = placed.model->mesh;
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    return moved(Triangle{.a = mesh.vertices[a], .b = mesh.vertices[b], .c = mesh.vertices[c]},
                 placed.placement);
}

}  // namespace

std::optional<MeshHit> intersect(const Ray& ray, const PlacedMesh& placed, Interval interval) {
    const auto& [mesh, bounds, packed] = *placed.model;
    const Ray in_frame = into_frame(ray, placed.placement);
    if (packed) return packed->nearest(in_frame, interval);
    if (!overlap(in_frame, bounds, interval)) return std::nullopt;
    return intersect(in_frame, mesh, interval);
}

bool blocks(const Ray& ray, const PlacedMesh& placed, Interval interval) {
    const std::optional<PackedMesh>& packed = placed.model->packed;
    if (!packed) return intersect(ray, placed, interval).has_value();
    return packed->blocks(into_frame(ray, placed.placement), interval);
}

SurfacePoint projected(const PlacedMesh& placed, const MeshHit& hit) {
    const Triangle triangle = triangle_of(placed, hit);
    const Vec3& w = hit.weights;
    auto [point, error] =
        projected(triangle, w.x * triangle.a + w.y * triangle.b + w.z * triangle.c);
    // In object space a mesh may be far from the origin, and its triangles are intersected there.
    const auto& [min, max] = placed.model->bounds;
    const Real in_frame = largest_component(glm::max(abs(min), abs(max)));
    const Motion& placement = placed.placement;
    const Real largest = placement.scale * in_frame + largest_component(placement.translation);
    return {.point = point, .error = glm::max(error, projection_error(largest))};
}

Vec3 normal(const PlacedMesh& placed, const MeshHit& hit) {
    const Mesh& mesh = placed.model->mesh;
    if (mesh.normals.empty()) return side(placed, hit);
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    return turned(
        interpolated_normal({mesh.normals[a], mesh.normals[b], mesh.normals[c]}, hit.weights),
        placed.placement);
}

Vec3 side(const PlacedMesh& placed, const MeshHit& hit) {
    const Triangle triangle = triangle_of(placed, hit);
    return normal(triangle, triangle.a);
}

}  // namespace rt
