#include "steps/step13_meshes/meshes.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"

#include <cmath>

namespace rt {

namespace {

/// The coordinates of v along the axes of the basis.
Vec3 in_frame(const Basis& basis, Vec3 v) {
    return {dot(v, basis.x), dot(v, basis.y), dot(v, basis.z)};
}

Triangle triangle_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    return {.a = mesh.vertices[corners[0]],
            .b = mesh.vertices[corners[1]],
            .c = mesh.vertices[corners[2]]};
}

/// 2 γ(3), relative to t: the t of a far face is rounded three times, and might be smaller than
/// that of the near one if both are the same edge (Ize 2013, "Robust BVH Ray Traversal").
constexpr Real far_padding = 2 * (3 * unit_roundoff) / (1 - 3 * unit_roundoff);

}  // namespace

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const Real o = ray.origin[axis];
        const Real d = ray.direction[axis];
        if (d == 0) {  // parallel to the slab; on a face the divisions would be 0 / 0
            if (!(box.min[axis] <= o && o <= box.max[axis])) return std::nullopt;
            continue;
        }
        const Real near = ((d > 0 ? box.min : box.max)[axis] - o) / d;
        const Real far = ((d > 0 ? box.max : box.min)[axis] - o) / d;
        const Real padded = far + far_padding * std::abs(far);
        if (!(near <= interval.min)) interval.min = near;  // NaN too, which then misses
        if (!(padded >= interval.max)) interval.max = padded;
        if (!(interval.min <= interval.max)) return std::nullopt;
    }
    return interval;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    // From the point of the line closest to the center, as in stage 7: the errors then depend on
    // the size of the box and not on the distance of the origin.
    const Vec3 from_center = ray.origin - box.center;
    const Real t_near = -dot(from_center, ray.direction) / dot(ray.direction, ray.direction);
    const Ray in_box{.origin = in_frame(box.basis, fused_at(from_center, t_near, ray.direction)),
                     .direction = in_frame(box.basis, ray.direction)};
    const auto inside = overlap(in_box, {.min = -box.half_size, .max = box.half_size},
                                {.min = -infinity, .max = infinity});
    if (!inside) return std::nullopt;
    // The padding decides whether there is a hit, but is no part of the answer.
    const Real exit = inside->max - far_padding * std::abs(inside->max);
    for (const Real from_p : {inside->min, exit}) {
        const Real t = t_near + from_p;
        if (interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    const Vec3 p = in_frame(box.basis, point - box.center);
    const Vec3 share = abs(p) / box.half_size;  // 1 on the face, less on the others
    if (share.x >= share.y && share.x >= share.z) return std::copysign(Real(1), p.x) * box.basis.x;
    if (share.y >= share.z) return std::copysign(Real(1), p.y) * box.basis.y;
    return std::copysign(Real(1), p.z) * box.basis.z;
}

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const Basis& basis = placement.rotation;
    return {.origin = in_frame(basis, ray.origin - placement.translation) / placement.scale,
            .direction = in_frame(basis, ray.direction) / placement.scale};
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    std::optional<MeshHit> nearest;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto t = intersect(ray, triangle_of(mesh, mesh.triangles[i]), interval);
        if (!t) continue;
        interval.max = *t;
        nearest = MeshHit{.t = *t, .triangle = i};
    }
    if (!nearest) return std::nullopt;
    nearest->weights =
        barycentric(triangle_of(mesh, mesh.triangles[nearest->triangle]), at(ray, nearest->t));
    return nearest;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    return unit(weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2]);
}

}  // namespace rt
