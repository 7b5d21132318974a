// origin: invented
// caught by: a mesh's triangles have the vertices that they name, counted from 0 (CR §4.2)
// sentence: You test a fixed number of triangles. A mesh may have any number: mesh.triangles.size().
#include <algorithm>
#include <cmath>
#include <utility>
#include "common/math/vector.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    Real in = interval.min;
    Real out = interval.max;
    for (int i = 0; i < 3; ++i) {
        const Real o = ray.origin[i];
        const Real d = ray.direction[i];
        if (std::isnan(o) || std::isnan(d)) return std::nullopt;
        if (d == 0) {
            if (o < box.min[i] || o > box.max[i]) return std::nullopt;
            continue;
        }
        Real t1 = (box.min[i] - o) / d;
        Real t2 = (box.max[i] - o) / d;
        if (t1 > t2) std::swap(t1, t2);
        in = std::max(in, t1);
        out = std::min(out, t2);
    }
    if (in > out) return std::nullopt;
    return Interval{.min = in, .max = out};
}

static Vec3 local(const Basis& basis, Vec3 v) {
    return {dot(v, basis.x), dot(v, basis.y), dot(v, basis.z)};
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    const Ray own{.origin = local(box.basis, ray.origin - box.center),
                  .direction = local(box.basis, ray.direction)};
    const auto part = overlap(own, {.min = -box.half_size, .max = box.half_size},
                              {.min = -infinity, .max = infinity});
    if (!part) return std::nullopt;
    if (interval.contains(part->min)) return part->min;
    if (interval.contains(part->max)) return part->max;
    return std::nullopt;
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    const Vec3 p = local(box.basis, point - box.center);
    int face = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(p[i]) / box.half_size[i] > std::abs(p[face]) / box.half_size[face]) face = i;
    const Vec3 axis = face == 0 ? box.basis.x : face == 1 ? box.basis.y : box.basis.z;
    return p[face] < 0 ? -axis : axis;
}

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const Vec3 o = ray.origin - placement.translation;
    return {.origin = local(placement.rotation, o) / placement.scale,
            .direction = local(placement.rotation, ray.direction) / placement.scale};
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> best;
    for (std::size_t i = 0; i < mesh.triangles.size() && i < 200; ++i) {
        const auto& corners = mesh.triangles[i];
        const Triangle triangle{mesh.vertices[corners[0]], mesh.vertices[corners[1]],
                                mesh.vertices[corners[2]]};
        const std::optional<Real> t = intersect(ray, triangle, interval);
        if (!t) continue;
        if (best && *t >= best->t) continue;
        best = MeshHit{
            .t = *t, .triangle = std::uint32_t(i), .weights = barycentric(triangle, at(ray, *t))};
    }
    return best;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    return unit(weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2]);
}

}  // namespace rt
