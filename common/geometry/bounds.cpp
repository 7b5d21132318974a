#include "common/geometry/bounds.hpp"

#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The padding of bounds, 16 u of the largest coordinate: a stage's own test finds hits within 8 u
/// of the shape, and the corners are computed within 4 u. For a ray that starts farther away, the
/// caller must widen the bounds.
Real padding(Real largest) {
    return 16 * unit_roundoff * largest;
}

Box padded(const Box& box) {
    const Vec3 wider(padding(largest_component(box)));
    return {.min = box.min - wider, .max = box.max + wider};
}

Ball padded(const Ball& ball) {
    const auto& [center, radius] = ball;
    return {.center = center, .radius = radius + padding(largest_component(center) + radius)};
}

Box around(Vec3 center, Vec3 reach) {
    return {.min = center - reach, .max = center + reach};
}

/// The extent of a circle along each axis: radius · the length of that axis projected into the
/// circle's plane, √(y² + z²) along x. √(1 − x²) would lose half the digits near x = 1.
Vec3 reach_of_circle(Vec3 axis, Real radius) {
    return radius *
           Vec3(std::hypot(axis.y, axis.z), std::hypot(axis.z, axis.x), std::hypot(axis.x, axis.y));
}

}  // namespace

Box bounds(const Sphere& sphere) {
    return padded(around(sphere.center, Vec3(sphere.radius)));
}

Box bounds(const Triangle& triangle) {
    return padded(united(united(united(Box{}, triangle.a), triangle.b), triangle.c));
}

Box bounds(const Square& square) {
    const Vec3 reach = square.side / 2 * (abs(square.basis.x) + abs(square.basis.y));
    return padded(around(square.center, reach));
}

Box bounds(const Cylinder& cylinder) {
    const Vec3 reach =
        cylinder.height / 2 * abs(cylinder.axis) + reach_of_circle(cylinder.axis, cylinder.radius);
    return padded(around(cylinder.center, reach));
}

Box bounds(const Cone& cone) {
    const Box rim =
        around(cone.apex + cone.height * cone.axis, reach_of_circle(cone.axis, cone.radius));
    return padded(united(rim, cone.apex));
}

Box bounds(const OrientedBox& box) {
    const auto& [x, y, z] = box.basis;
    const Vec3& half = box.half_size;
    return padded(around(box.center, half.x * abs(x) + half.y * abs(y) + half.z * abs(z)));
}

Box bounds(const Mesh& mesh) {
    Box box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box = united(box, mesh.vertices[vertex]);
    return box;
}

Ball ball_around(const Sphere& sphere) {
    return padded(Ball{.center = sphere.center, .radius = sphere.radius});
}

Ball ball_around(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 center = a / Real(3) + b / Real(3) + c / Real(3);
    const Real radius =
        glm::max(length(a - center), glm::max(length(b - center), length(c - center)));
    return padded(Ball{.center = center, .radius = radius});
}

Ball ball_around(const Square& square) {
    return padded(Ball{.center = square.center, .radius = square.side / std::sqrt(Real(2))});
}

Ball ball_around(const Cylinder& cylinder) {
    return padded(Ball{.center = cylinder.center,
                       .radius = std::hypot(cylinder.radius, cylinder.height / 2)});
}

Ball ball_around(const Cone& cone) {
    const auto& [apex, axis, radius, height] = cone;
    // The sphere through the apex and the rim; for a blunt cone the sphere around the rim, which
    // contains the apex.
    const Real slant = std::hypot(radius, height);
    const Real from_apex = radius < height ? slant / 2 * (slant / height) : height;
    return padded(Ball{.center = apex + from_apex * axis, .radius = glm::max(radius, from_apex)});
}

Ball ball_around(const OrientedBox& box) {
    return padded(Ball{.center = box.center, .radius = length(box.half_size)});
}

Ball ball_around(const Box& box) {
    const Vec3 center = box.min / Real(2) + box.max / Real(2);
    return padded(Ball{.center = center, .radius = length(box.max - center)});
}

}  // namespace rt
