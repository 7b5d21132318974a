// Rigid transforms and reflections with a uniform scale, applied to shapes as values: the shape
// itself is transformed, so that no cached quantity can be out of date (HAI). The file of each kind
// of shape defines `transformed(shape, transform)`.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/basis.hpp"

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

/// Returns whether the rotation is a reflection, as in a scene whose axes are left-handed: a
/// triangle that was counterclockwise is clockwise then.
[[nodiscard]] inline bool is_reflection(const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    return dot(cross(x, y), z) < 0;
}

/// The direction rotated; its length does not change.
[[nodiscard]] inline Vec3 rotated(Vec3 v, const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    return v.x * x + v.y * y + v.z * z;
}

/// The basis with its directions rotated.
[[nodiscard]] inline Basis rotated(const Basis& basis, const Transform& transform) {
    return {.x = rotated(basis.x, transform),
            .y = rotated(basis.y, transform),
            .z = rotated(basis.z, transform)};
}

[[nodiscard]] inline Vec3 transformed(Vec3 point, const Transform& transform) {
    return transform.scale * rotated(point, transform) + transform.translation;
}

/// The ray transformed. Each of its points keeps its t, because the direction is scaled too.
[[nodiscard]] inline Ray transformed(const Ray& ray, const Transform& transform) {
    return {.origin = transformed(ray.origin, transform),
            .direction = transform.scale * rotated(ray.direction, transform)};
}

}  // namespace rt
