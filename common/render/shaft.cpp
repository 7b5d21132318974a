#include "common/render/shaft.hpp"

#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// A bound on the error of every shape's rounded test, in units of u times the largest coordinate:
/// twice the value that the boxes of a hierarchy allow for (node_intersector.hpp).
constexpr Real test_roundings = 64;

/// A bound on the rounding error of a distance from a plane. Shadow rays start 16 off the surface,
/// minus the 8 by which their origin may be off it (projection.hpp), so that for a flat shape at
/// their origin the test usually detects that they leave it.
constexpr Real distance_roundings = 6;

}  // namespace

Shaft::Shaft(Vec3 point, const Light& light)
    : point_(point),
      center_(light.position),
      radius_(light.radius),
      bounds_{.min = glm::min(point, center_ - radius_), .max = glm::max(point, center_ + radius_)},
      size_(largest_component(bounds_)) {
    const Vec3 along = center_ - point_;
    const Real distance = length(along);
    if (!(radius_ < distance && distance < infinity)) return;
    axis_ = along / distance;
    sine_ = radius_ / distance;
    cosine_ = std::sqrt((1 - sine_) * (1 + sine_));
}

Real Shaft::roundings(Real units, Real largest) const {
    return units * unit_roundoff * glm::max(size_, largest);
}

bool Shaft::beside_plane(Vec3 in_plane, Vec3 normal, Real normal_error) const {
    const Real square = dot(normal, normal);
    if (!is_safe_square(square)) return false;  // its length is unknown
    const Real size = std::sqrt(square);
    const Real largest = largest_component(in_plane);
    const Vec3 to_point = point_ - in_plane;
    const Vec3 to_center = center_ - in_plane;
    const Real point = dot(to_point, normal);
    const Real center = dot(to_center, normal);
    const Real off = roundings(distance_roundings, largest);
    const Real ball = radius_ + roundings(test_roundings, largest);
    return std::abs(point) > off * size + normal_error * length(to_point) &&
           std::abs(center) > ball * size + normal_error * (length(to_center) + ball) &&
           (point > 0) == (center > 0);
}

bool Shaft::beside_ball(Vec3 center, Real radius) const {
    const Vec3 to_center = center - point_;
    const Real along = dot(to_center, axis_);
    const Real across = length(to_center - along * axis_);
    return cosine_ > 0 && across * cosine_ - along * sine_ > radius;
}

bool Shaft::may_intersect(const BoundingBox& box) const {
    const Real slack = roundings(test_roundings, largest_component(box));
    for (glm::length_t i = 0; i < 3; ++i)
        if (box.max[i] + slack < bounds_.min[i] || box.min[i] - slack > bounds_.max[i])
            return false;
    const auto [middle, radius] = bounding_sphere(box);
    return !beside_ball(middle, radius + slack);
}

bool Shaft::may_intersect(const BoundingSphere& ball) const {
    const auto& [center, radius] = ball;
    const Real slack = roundings(test_roundings, largest_component(center) + radius);
    return !beside_ball(center, radius + slack);
}

bool Shaft::may_intersect(const Sphere& sphere) const {
    const auto& [center, radius] = sphere;
    const Real largest = largest_component(center) + radius;
    const Real slack = roundings(test_roundings, largest);
    if (beside_ball(center, radius + slack)) return false;
    for (glm::length_t i = 0; i < 3; ++i)
        if (center[i] + (radius + slack) < bounds_.min[i] ||
            center[i] - (radius + slack) > bounds_.max[i])
            return false;
    // For a point near the sphere, the tangent plane between them separates the sphere from the
    // shaft.
    const Vec3 outward = point_ - center;
    const Real distance = length(outward);
    return !(distance > radius + roundings(distance_roundings, largest) &&
             dot(center_ - center, outward) > (radius + radius_ + slack) * distance);
}

bool Shaft::may_intersect(const Plane& plane) const {
    return !beside_plane(plane.point, plane.normal, 0);
}

bool Shaft::may_intersect(const Triangle& triangle) const {
    const auto& [a, b, c] = triangle;
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Real error =
        4 * unit_roundoff * length(ab) * length(ac);  // for a sliver, as large as the normal
    return may_intersect(bounds(triangle)) && !beside_plane(a, cross(ab, ac), error);
}

bool Shaft::may_intersect(const Square& square) const {
    return may_intersect(bounds(square)) && !beside_plane(square.center, square.basis.z, 0);
}

}  // namespace rt
