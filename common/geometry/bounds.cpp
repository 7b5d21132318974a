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

BoundingBox padded(const BoundingBox& box) {
    const Vec3 wider(padding(largest_component(box)));
    return {.min = box.min - wider, .max = box.max + wider};
}

BoundingSphere padded(const BoundingSphere& ball) {
    const auto& [center, radius] = ball;
    return {.center = center, .radius = radius + padding(largest_component(center) + radius)};
}

BoundingBox around(Vec3 center, Vec3 reach) {
    return {.min = center - reach, .max = center + reach};
}

/// The extent of a circle along each axis: radius · the length of that axis projected into the
/// circle's plane, √(y² + z²) along x. √(1 − x²) would lose half the digits near x = 1.
Vec3 reach_of_circle(Vec3 axis, Real radius) {
    return radius *
           Vec3(std::hypot(axis.y, axis.z), std::hypot(axis.z, axis.x), std::hypot(axis.x, axis.y));
}

}  // namespace

BoundingBox bounds(const Sphere& sphere) {
    return padded(around(sphere.center, Vec3(sphere.radius)));
}

BoundingBox bounds(const Triangle& triangle) {
    return padded(merged(merged(merged(BoundingBox{}, triangle.a), triangle.b), triangle.c));
}

BoundingBox bounds(const Square& square) {
    const Vec3 reach = square.side / 2 * (abs(square.basis.x) + abs(square.basis.y));
    return padded(around(square.center, reach));
}

BoundingBox bounds(const Cylinder& cylinder) {
    const Vec3 reach =
        cylinder.height / 2 * abs(cylinder.axis) + reach_of_circle(cylinder.axis, cylinder.radius);
    return padded(around(cylinder.center, reach));
}

BoundingBox bounds(const Cone& cone) {
    const BoundingBox rim =
        around(cone.apex + cone.height * cone.axis, reach_of_circle(cone.axis, cone.radius));
    return padded(merged(rim, cone.apex));
}

BoundingBox bounds(const OrientedBox& box) {
    const auto& [x, y, z] = box.basis;
    const Vec3& half = box.half_size;
    return padded(around(box.center, half.x * abs(x) + half.y * abs(y) + half.z * abs(z)));
}

BoundingBox bounds(const Mesh& mesh) {
    BoundingBox box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box = merged(box, mesh.vertices[vertex]);
    return box;
}

BoundingSphere bounding_sphere(const Sphere& sphere) {
    return padded(BoundingSphere{.center = sphere.center, .radius = sphere.radius});
}

BoundingSphere bounding_sphere(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 center = a / Real(3) + b / Real(3) + c / Real(3);
    const Real radius =
        glm::max(length(a - center), glm::max(length(b - center), length(c - center)));
    return padded(BoundingSphere{.center = center, .radius = radius});
}

BoundingSphere bounding_sphere(const Square& square) {
    return padded(
        BoundingSphere{.center = square.center, .radius = square.side / std::sqrt(Real(2))});
}

BoundingSphere bounding_sphere(const Cylinder& cylinder) {
    return padded(BoundingSphere{.center = cylinder.center,
                                 .radius = std::hypot(cylinder.radius, cylinder.height / 2)});
}

BoundingSphere bounding_sphere(const Cone& cone) {
    const auto& [apex, axis, radius, height] = cone;
    // The sphere through the apex and the rim; for a blunt cone the sphere around the rim, which
    // contains the apex.
    const Real slant = std::hypot(radius, height);
    const Real from_apex = radius < height ? slant / 2 * (slant / height) : height;
    return padded(
        BoundingSphere{.center = apex + from_apex * axis, .radius = glm::max(radius, from_apex)});
}

BoundingSphere bounding_sphere(const OrientedBox& box) {
    return padded(BoundingSphere{.center = box.center, .radius = length(box.half_size)});
}

BoundingSphere bounding_sphere(const BoundingBox& box) {
    const Vec3 center = box.min / Real(2) + box.max / Real(2);
    return padded(BoundingSphere{.center = center, .radius = length(box.max - center)});
}

}  // namespace rt
