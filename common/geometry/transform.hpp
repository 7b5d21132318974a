// Rigid transforms with a uniform scale, applied to shapes as values: the shape itself is
// transformed, so that no cached quantity can be out of date (HAI).
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/shapes.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The transform p ↦ scale · (p rotated) + translation. The rotation maps (1, 0, 0), (0, 1, 0), (0,
/// 0, 1) to its x, y, z. Every shape keeps its kind, and every angle its size.
struct Motion {
    Basis rotation;
    Real scale = 1;  ///< positive
    Vec3 translation;

    bool operator==(const Motion&) const = default;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The direction rotated; its length does not change.
[[nodiscard]] inline Vec3 turned(Vec3 v, const Motion& motion) {
    const auto& [x, y, z] = motion.rotation;
    return v.x * x + v.y * y + v.z * z;
}

/// The point transformed.
[[nodiscard]] inline Vec3 moved(Vec3 point, const Motion& motion) {
    return motion.scale * turned(point, motion) + motion.translation;
}

/// The ray transformed. Each of its points keeps its t, because the direction is scaled too.
[[nodiscard]] inline Ray moved(const Ray& ray, const Motion& motion) {
    return {.origin = moved(ray.origin, motion),
            .direction = motion.scale * turned(ray.direction, motion)};
}

[[nodiscard]] inline Sphere moved(const Sphere& sphere, const Motion& motion) {
    return {.center = moved(sphere.center, motion), .radius = motion.scale * sphere.radius};
}

[[nodiscard]] inline Plane moved(const Plane& plane, const Motion& motion) {
    return {.point = moved(plane.point, motion), .normal = turned(plane.normal, motion)};
}

[[nodiscard]] inline Triangle moved(const Triangle& triangle, const Motion& motion) {
    return {.a = moved(triangle.a, motion),
            .b = moved(triangle.b, motion),
            .c = moved(triangle.c, motion)};
}

[[nodiscard]] inline Square moved(const Square& square, const Motion& motion) {
    const auto& [x, y, z] = square.basis;
    return {.center = moved(square.center, motion),
            .basis = {.x = turned(x, motion), .y = turned(y, motion), .z = turned(z, motion)},
            .side = motion.scale * square.side,
            .one_sided = square.one_sided};
}

[[nodiscard]] inline Cylinder moved(const Cylinder& cylinder, const Motion& motion) {
    return {.center = moved(cylinder.center, motion),
            .axis = turned(cylinder.axis, motion),
            .radius = motion.scale * cylinder.radius,
            .height = motion.scale * cylinder.height};
}

[[nodiscard]] inline OrientedBox moved(const OrientedBox& box, const Motion& motion) {
    const auto& [x, y, z] = box.basis;
    return {.center = moved(box.center, motion),
            .basis = {.x = turned(x, motion), .y = turned(y, motion), .z = turned(z, motion)},
            .half_size = motion.scale * box.half_size};
}

[[nodiscard]] inline Cone moved(const Cone& cone, const Motion& motion) {
    return {.apex = moved(cone.apex, motion),
            .axis = turned(cone.axis, motion),
            .radius = motion.scale * cone.radius,
            .height = motion.scale * cone.height};
}

}  // namespace rt
