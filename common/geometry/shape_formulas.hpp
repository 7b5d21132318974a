// Formulas that the files of several kinds of shapes share: paddings, circles, planes, surfaces of
// revolution. They have a namespace of their own, because a stage may use the same names.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/projection.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt::geometry {
inline namespace RT_PRECISION {

/// A point in the half-plane of a surface of revolution: its coordinates from the axis and along
/// it.
struct Meridian {
    Real across;
    Real along;
};

}  // namespace RT_PRECISION
}  // namespace rt::geometry

namespace rt::geometry {

/// The padding of bounds, 16 u of the largest coordinate: the corners are computed within 4 u of
/// it. A stage's own test finds hits near the shape, within 34 u of the largest coordinate of the
/// ray's origin relative to it, as far as that is derived (docs/reference/error_bounds.md): the
/// caller must widen the bounds by that.
[[nodiscard]] inline Real padding(Real largest) {
    return 16 * unit_roundoff * largest;
}

[[nodiscard]] inline BoundingBox padded(const BoundingBox& box) {
    const Vec3 wider(padding(largest_component(box)));
    return {.min = box.min - wider, .max = box.max + wider};
}

[[nodiscard]] inline BoundingSphere padded(const BoundingSphere& ball) {
    const auto& [center, radius] = ball;
    return {.center = center, .radius = radius + padding(largest_component(center) + radius)};
}

/// The box that extends by `reach` to both sides of the center.
[[nodiscard]] inline BoundingBox around(Vec3 center, Vec3 reach) {
    return {.min = center - reach, .max = center + reach};
}

/// The extent of a circle along each axis: radius · the length of that axis projected into the
/// circle's plane, √(y² + z²) along x. √(1 − x²) would lose half the digits near x = 1.
[[nodiscard]] inline Vec3 reach_of_circle(Vec3 axis, Real radius) {
    return radius *
           Vec3(std::hypot(axis.y, axis.z), std::hypot(axis.z, axis.x), std::hypot(axis.x, axis.y));
}

/// The projected point with its error bound, for a shape whose own coordinates are at most `size`.
[[nodiscard]] inline PointWithError bounded(Vec3 point, Real size) {
    return {.point = point, .error = projection_error(glm::max(largest_component(point), size))};
}

/// The nearest point of the plane through `in_plane` with the unit normal `normal`.
[[nodiscard]] inline Vec3 onto_plane(Vec3 point, Vec3 in_plane, Vec3 normal) {
    return point - dot(point - in_plane, normal) * normal;
}

/// A unit vector perpendicular to the axis, rotated around it by `turn` of a full turn.
[[nodiscard]] inline Vec3 perpendicular(Vec3 axis, Real turn) {
    const Vec3 aside = std::abs(axis.x) < Real(0.6) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 x = unit(cross(axis, aside));
    return std::cos(2 * pi * turn) * x + std::sin(2 * pi * turn) * cross(axis, x);
}

/// The meridian coordinates of a point, relative to the center of the surface.
[[nodiscard]] inline Meridian meridian(Vec3 from_center, Vec3 axis) {
    return {.across = length(cross(from_center, axis)), .along = dot(from_center, axis)};
}

[[nodiscard]] inline Real distance_to_segment(Vec3 point, Vec3 a, Vec3 b) {
    const Vec3 ab = b - a;
    const Real square = dot(ab, ab);
    const Real part = square > 0 ? glm::clamp(dot(point - a, ab) / square, Real(0), Real(1)) : 0;
    return length(point - (a + part * ab));
}

}  // namespace rt::geometry
