#include "common/bounds.hpp"

#include "common/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// Wider by 16 u of the largest coordinate: a stage's own test places a hit within 8 u of it, the
/// corners come out within 4 u, and a ray that starts further away is the hierarchy's to widen for.
Box padded(const Box& box) {
    const Real largest = largest_component(box);
    const Vec3 padding(16 * unit_roundoff * largest);
    return {.min = box.min - padding, .max = box.max + padding};
}

Box around(Vec3 center, Vec3 reach) {
    return {.min = center - reach, .max = center + reach};
}

/// How far a circle reaches along each axis: radius · the part of that axis in its plane,
/// √(y² + z²) along x. √(1 − x²) would lose half the digits near x = 1.
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

}  // namespace rt
