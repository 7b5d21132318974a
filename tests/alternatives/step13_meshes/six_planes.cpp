// right: M1 to the letter: three pairs of planes, each by stage 4's formula
#include "tests/alternatives/step13_meshes/stage5.hpp"

#define overlap(...) correct_overlap(__VA_ARGS__)
#define intersect(...) correct_intersect(__VA_ARGS__)
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap
#undef intersect
#undef normal
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
