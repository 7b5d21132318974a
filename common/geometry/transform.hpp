// Rigid transforms with a uniform scale, applied to shapes as values: the shape itself is
// transformed, so that no cached quantity can be out of date (HAI).
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/shapes.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The transform p ↦ scale · (p rotated) + translation. The rotation maps (1, 0, 0), (0, 1, 0), (0,
/// 0, 1) to its x, y, z. Every shape keeps its kind, and every angle its size.
struct Transform {
    Basis rotation;
    Real scale = 1;  ///< positive
    Vec3 translation;

    bool operator==(const Transform&) const = default;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The direction rotated; its length does not change.
[[nodiscard]] inline Vec3 rotated(Vec3 v, const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    return v.x * x + v.y * y + v.z * z;
}

/// The point transformed.
[[nodiscard]] inline Vec3 transformed(Vec3 point, const Transform& transform) {
    return transform.scale * rotated(point, transform) + transform.translation;
}

/// The ray transformed. Each of its points keeps its t, because the direction is scaled too.
[[nodiscard]] inline Ray transformed(const Ray& ray, const Transform& transform) {
    return {.origin = transformed(ray.origin, transform),
            .direction = transform.scale * rotated(ray.direction, transform)};
}

[[nodiscard]] inline Sphere transformed(const Sphere& sphere, const Transform& transform) {
    return {.center = transformed(sphere.center, transform),
            .radius = transform.scale * sphere.radius};
}

[[nodiscard]] inline Plane transformed(const Plane& plane, const Transform& transform) {
    return {.point = transformed(plane.point, transform),
            .normal = rotated(plane.normal, transform)};
}

[[nodiscard]] inline Triangle transformed(const Triangle& triangle, const Transform& transform) {
    return {.a = transformed(triangle.a, transform),
            .b = transformed(triangle.b, transform),
            .c = transformed(triangle.c, transform)};
}

[[nodiscard]] inline Square transformed(const Square& square, const Transform& transform) {
    const auto& [x, y, z] = square.basis;
    return {.center = transformed(square.center, transform),
            .basis = {.x = rotated(x, transform),
                      .y = rotated(y, transform),
                      .z = rotated(z, transform)},
            .side = transform.scale * square.side,
            .one_sided = square.one_sided};
}

[[nodiscard]] inline Cylinder transformed(const Cylinder& cylinder, const Transform& transform) {
    return {.center = transformed(cylinder.center, transform),
            .axis = rotated(cylinder.axis, transform),
            .radius = transform.scale * cylinder.radius,
            .height = transform.scale * cylinder.height};
}

[[nodiscard]] inline OrientedBox transformed(const OrientedBox& box, const Transform& transform) {
    const auto& [x, y, z] = box.basis;
    return {.center = transformed(box.center, transform),
            .basis = {.x = rotated(x, transform),
                      .y = rotated(y, transform),
                      .z = rotated(z, transform)},
            .half_size = transform.scale * box.half_size};
}

[[nodiscard]] inline Cone transformed(const Cone& cone, const Transform& transform) {
    return {.apex = transformed(cone.apex, transform),
            .axis = rotated(cone.axis, transform),
            .radius = transform.scale * cone.radius,
            .height = transform.scale * cone.height};
}

}  // namespace rt
