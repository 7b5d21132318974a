// Points brought back onto the surface that they were computed to be on.
//
// A hit's point o + t d is off by what t and o are off, which grows with the distance of the eye.
// Moved to the nearest point of the shape it is off by a few roundings of the shape's own
// coordinates, and then a ray may leave it from a distance that is known to be enough (stage 10).
#pragma once

#include "common/compensated.hpp"
#include "common/shapes.hpp"
#include "common/vector.hpp"

#include <cmath>

namespace rt::inline RT_PRECISION {

/// A point, and a bound on its distance from the shape.
struct SurfacePoint {
    Vec3 point;
    Real error;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The bound that holds for a point that was projected, if no coordinate that went into it is
/// larger than `largest`.
[[nodiscard]] inline Real projection_error(Real largest) {
    // In units of u times the largest coordinate. Measured over 10⁶ rays of every kind of shape: a
    // point is off by 4.5 at most, and to be beyond the reach of its own shape's formula it must be
    // moved by 6, of a triangle in a placed mesh by 8. This is twice that.
    constexpr Real roundings = 16;
    return roundings * unit_roundoff * largest;
}

/// A projected point of a shape none of whose own coordinates is larger than `size`.
[[nodiscard]] inline SurfacePoint bounded(Vec3 point, Real size) {
    return {.point = point, .error = projection_error(glm::max(largest_component(point), size))};
}

/// The nearest point of the plane through `in_plane`, whose unit normal is given.
[[nodiscard]] inline Vec3 onto_plane(Vec3 point, Vec3 in_plane, Vec3 normal) {
    return point - dot(point - in_plane, normal) * normal;
}

// Each returns the point of the shape's surface, its edges apart, that is nearest to the given one,
// which must be near already. Where there is no nearest one, on an axis, it stays.

[[nodiscard]] inline SurfacePoint projected(const Sphere& sphere, Vec3 point) {
    const auto& [center, radius] = sphere;
    const Vec3 outward = point - center;
    if (outward == Vec3(0)) return bounded(point, radius);
    return bounded(center + radius * unit(outward), largest_component(center) + radius);
}

[[nodiscard]] inline SurfacePoint projected(const Plane& plane, Vec3 point) {
    return bounded(onto_plane(point, plane.point, unit(plane.normal)),
                   largest_component(plane.point));
}

[[nodiscard]] inline SurfacePoint projected(const Triangle& triangle, Vec3 point) {
    const auto& [a, b, c] = triangle;
    // Of a sliver, the plain cross product leaves too few digits to stay in its plane.
    const Vec3 normal = compensated_cross(b - a, c - a);
    const Real size =
        glm::max(largest_component(a), glm::max(largest_component(b), largest_component(c)));
    if (normal == Vec3(0)) return bounded(point, size);
    return bounded(onto_plane(point, a, unit(normal)), size);
}

[[nodiscard]] inline SurfacePoint projected(const Square& square, Vec3 point) {
    return bounded(onto_plane(point, square.center, square.basis.z),
                   largest_component(square.center) + square.side);
}

[[nodiscard]] inline SurfacePoint projected(const Cylinder& cylinder, Vec3 point) {
    const auto& [center, axis, radius, height] = cylinder;
    const Real size = largest_component(center) + radius + height;
    const Vec3 along = dot(point - center, axis) * axis;
    const Vec3 across = point - center - along;
    if (across == Vec3(0)) return bounded(point, size);
    return bounded(center + along + radius * unit(across), size);
}

[[nodiscard]] inline SurfacePoint projected(const Cone& cone, Vec3 point) {
    const auto& [apex, axis, radius, height] = cone;
    const Real size = largest_component(apex) + radius + height;
    const Real z = dot(point - apex, axis);
    const Vec3 across = point - apex - z * axis;
    if (across == Vec3(0)) return bounded(point, size);
    // Along the side, from the apex: in the half-plane through the axis and the point.
    const Vec3 outward = unit(across);
    const Vec3 side = unit(height * axis + radius * outward);
    return bounded(apex + dot(point - apex, side) * side, size);
}

[[nodiscard]] inline SurfacePoint projected(const OrientedBox& box, Vec3 point) {
    const auto& [center, basis, half_size] = box;
    const Vec3 p(dot(point - center, basis.x), dot(point - center, basis.y),
                 dot(point - center, basis.z));
    const Vec3 share = abs(p) / half_size;  // 1 on the face, less on the others
    const Vec3 axes[] = {basis.x, basis.y, basis.z};
    const glm::length_t i =
        share.x > share.y ? (share.x > share.z ? 0 : 2) : (share.y > share.z ? 1 : 2);
    const Real off = std::copysign(half_size[i], p[i]) - p[i];
    return bounded(point + off * axes[i],
                   largest_component(center) + half_size.x + half_size.y + half_size.z);
}

}  // namespace rt
