// right all_hits_compared around intersect interpolated_normal: CR §4.2's loop, t compared at the
// end, and CR §4.1's areas
#include "tests/alternatives/stage5.hpp"

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

// right by_matrix around to_object_space: HAI's matrices: the placement as one matrix, the ray by
// its inverse
#include <glm/matrix.hpp>

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const auto& [x, y, z] = placement.rotation;
    Mat4 matrix(1);
    matrix[0] = Vec4(placement.scale * x, 0);
    matrix[1] = Vec4(placement.scale * y, 0);
    matrix[2] = Vec4(placement.scale * z, 0);
    matrix[3] = Vec4(placement.translation, 1);
    const Mat4 inverse = glm::inverse(matrix);
    return {.origin = Vec3(inverse * Vec4(ray.origin, 1)),
            .direction = Vec3(inverse * Vec4(ray.direction, 0))};
}

}  // namespace rt

// right six_planes around overlap intersect normal: M1 to the letter: three pairs of planes, each
// by stage 4's formula
#include "tests/alternatives/stage5.hpp"

#include <algorithm>

namespace rt {

/// The interval between the planes through c − e and c + e across e, e · e = half · half.
Interval between_planes(const Ray& ray, Vec3 center, Vec3 axis, Real half) {
    const Real speed = dot(ray.direction, axis);
    const Real to_first = dot(center - half * axis - ray.origin, axis);
    const Real to_second = dot(center + half * axis - ray.origin, axis);
    if (speed == 0) {
        const bool within = to_first <= 0 && to_second >= 0;
        return within ? Interval{.min = -infinity} : Interval{.min = infinity, .max = -infinity};
    }
    const Real t1 = to_first / speed;
    const Real t2 = to_second / speed;
    return t1 < t2 ? Interval{.min = t1, .max = t2} : Interval{.min = t2, .max = t1};
}

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    const Vec3 size = box.max - box.min;
    const std::array<Vec3, 3> axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    if (std::isnan(dot(ray.origin, ray.direction))) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = ray.origin[axis];
        const Real d = ray.direction[axis];
        if (d == 0 && (o < box.min[axis] || o > box.max[axis])) return std::nullopt;
        if (d == 0) continue;
        const auto [t_min, t_max] = std::minmax({(box.min[axis] - o) / d, (box.max[axis] - o) / d});
        interval.min = std::max(interval.min, t_min);
        interval.max = std::min(interval.max, t_max);
    }
    if (interval.min > interval.max) return std::nullopt;
    return interval;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    const Interval u = between_planes(ray, box.center, box.basis.x, box.half_size.x);
    const Interval v = between_planes(ray, box.center, box.basis.y, box.half_size.y);
    const Interval w = between_planes(ray, box.center, box.basis.z, box.half_size.z);
    const Real t_min = std::max({u.min, v.min, w.min});
    const Real t_max = std::min({u.max, v.max, w.max});
    if (std::isnan(dot(ray.origin, ray.direction)) || !(t_min <= t_max)) return std::nullopt;
    if (interval.contains(t_min)) return t_min;
    if (interval.contains(t_max)) return t_max;
    return std::nullopt;
}

/// By the distance to each face.
Vec3 normal(const OrientedBox& box, Vec3 point) {
    const std::array<Vec3, 3> axes = {box.basis.x, box.basis.y, box.basis.z};
    Vec3 nearest(0);
    Real least = infinity;
    for (int i = 0; i < 3; ++i)
        for (const Real sign : {Real(-1), Real(1)}) {
            const Vec3 outward = sign * axes[i];
            const Real off = std::abs(dot(point - box.center, outward) - box.half_size[i]);
            if (off >= least) continue;
            least = off;
            nearest = outward;
        }
    return nearest;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return correct_intersect(ray, mesh, interval);
}

}  // namespace rt

// right williams around overlap: the algorithm of M1's second paper, by 1 / d and its sign
namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    // A comparison with NaN is false: 0 · ∞ on a face is no bound.
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isnan(ray.origin[axis]) || std::isnan(ray.direction[axis])) return std::nullopt;
        const Real inverse = 1 / ray.direction[axis];
        const bool backwards = std::signbit(inverse);
        const Real t_min = ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) * inverse;
        const Real t_max = ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) * inverse;
        if (interval.min > t_max || t_min > interval.max) return std::nullopt;
        if (t_min > interval.min) interval.min = t_min;
        if (t_max < interval.max) interval.max = t_max;
    }
    return interval;
}

}  // namespace rt
