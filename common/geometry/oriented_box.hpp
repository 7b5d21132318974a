// Oriented boxes, and what the program needs of them (shape.hpp). Their stage defines `intersect`
// and `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// |x|, |y| and |z| ≤ the components of half_size in object space (M1, "boite orientée").
struct OrientedBox {
    Vec3 center;
    Basis basis;
    Vec3 half_size{Real(0.5)};  ///< along x, y and z of the basis

    bool operator==(const OrientedBox&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<OrientedBox> =
    record_of("OrientedBox", field("center", &OrientedBox::center),
              field("basis", &OrientedBox::basis), field("half_size", &OrientedBox::half_size));

/// The shape transformed.
[[nodiscard]] inline OrientedBox transformed(const OrientedBox& box, const Transform& transform) {
    return {.center = transformed(box.center, transform),
            .basis = rotated(box.basis, transform),
            .half_size = transform.scale * box.half_size};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const OrientedBox& box) {
    const auto& [x, y, z] = box.basis;
    const Vec3& half = box.half_size;
    return geometry::padded(
        geometry::around(box.center, half.x * abs(x) + half.y * abs(y) + half.z * abs(z)));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const OrientedBox& box) {
    return geometry::padded(BoundingSphere{.center = box.center, .radius = length(box.half_size)});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const OrientedBox& box, Vec3 point) {
    const auto& [center, basis, half_size] = box;
    const Vec3 p(dot(point - center, basis.x), dot(point - center, basis.y),
                 dot(point - center, basis.z));
    const Vec3 share = abs(p) / half_size;  // 1 on the face of the point, less on the others
    const Vec3 axes[] = {basis.x, basis.y, basis.z};
    const glm::length_t i =
        share.x > share.y ? (share.x > share.z ? 0 : 2) : (share.y > share.z ? 1 : 2);
    const Real off = std::copysign(half_size[i], p[i]) - p[i];
    return geometry::bounded(point + off * axes[i],
                             largest_component(center) + half_size.x + half_size.y + half_size.z);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const OrientedBox& box) {
    const Vec3 half = box.half_size;
    return 2 * glm::min(half.x, glm::min(half.y, half.z));
}

/// A point of the surface: a third of the unit square maps to the two faces across each axis, and
/// equal areas of it to equal areas of a face.
[[nodiscard]] inline Vec3 surface_point(const OrientedBox& box, Vec2 place) {
    const auto& [x, y, z] = box.basis;
    // The index of the face, and the position in it.
    const auto face = glm::min(int(6 * place.x), 5);
    const Real part = 6 * place.x - Real(face);
    const Real side = face % 2 == 0 ? -1 : 1;
    Vec3 in_box(2 * part - 1, 2 * place.y - 1, side);
    if (face / 2 == 0) in_box = {side, in_box.x, in_box.y};
    if (face / 2 == 1) in_box = {in_box.x, side, in_box.y};
    in_box *= box.half_size;
    return box.center + in_box.x * x + in_box.y * y + in_box.z * z;
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const OrientedBox& box) {
    const Vec3 from_center = point - box.center;
    const auto& [x, y, z] = box.basis;
    const Vec3 in_box(dot(from_center, x), dot(from_center, y), dot(from_center, z));
    const Vec3 beyond = abs(in_box) - box.half_size;
    const Real outside = length(glm::max(beyond, Vec3(0)));
    return outside > 0 ? outside : -glm::max(beyond.x, glm::max(beyond.y, beyond.z));
}

// Defined by the stage, in story.cpp.
const char* explain(PixelLog& log, const Ray& ray, const OrientedBox& box);

}  // namespace rt
