// The inputs of a stage, converted exactly from floats.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "tests/oracle/camera.hpp"
#include "tests/oracle/shapes.hpp"

namespace rt {

[[nodiscard]] inline oracle::ExactVector exact(Vec3 v) {
    return {v.x, v.y, v.z};
}

[[nodiscard]] inline oracle::Ray exact(const Ray& ray) {
    return {.origin = exact(ray.origin), .direction = exact(ray.direction)};
}

[[nodiscard]] inline oracle::Interval exact(const Interval& interval) {
    oracle::Interval same{.min = interval.min, .max = std::nullopt};
    if (interval.max != infinity) same.max = interval.max;
    return same;
}

[[nodiscard]] inline oracle::Basis<oracle::Exact> exact(const Basis& basis) {
    return {.x = exact(basis.x), .y = exact(basis.y), .z = exact(basis.z)};
}

[[nodiscard]] inline oracle::Matrix exact(const Mat4& matrix) {
    oracle::Matrix same;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            same[std::size_t(row)][std::size_t(column)] = double(matrix[column][row]);
    return same;
}

[[nodiscard]] inline oracle::Sphere exact(const Sphere& sphere) {
    return {.center = exact(sphere.center), .radius = sphere.radius};
}

[[nodiscard]] inline oracle::Plane exact(const Plane& plane) {
    return {.point = exact(plane.point), .normal = exact(plane.normal)};
}

[[nodiscard]] inline oracle::Triangle exact(const Triangle& triangle) {
    return {.a = exact(triangle.a), .b = exact(triangle.b), .c = exact(triangle.c)};
}

[[nodiscard]] inline oracle::Square exact(const Square& square) {
    return {.center = exact(square.center),
            .x = exact(square.basis.x),
            .y = exact(square.basis.y),
            .z = exact(square.basis.z),
            .side = square.side,
            .one_sided = square.one_sided};
}

[[nodiscard]] inline oracle::Cylinder exact(const Cylinder& cylinder) {
    return {.center = exact(cylinder.center),
            .axis = exact(cylinder.axis),
            .radius = cylinder.radius,
            .height = cylinder.height};
}

[[nodiscard]] inline oracle::Cone exact(const Cone& cone) {
    return {.apex = exact(cone.apex),
            .axis = exact(cone.axis),
            .radius = cone.radius,
            .height = cone.height};
}

[[nodiscard]] inline oracle::OrientedBox exact(const OrientedBox& box) {
    return {.center = exact(box.center),
            .x = exact(box.basis.x),
            .y = exact(box.basis.y),
            .z = exact(box.basis.z),
            .half_size = exact(box.half_size)};
}

}  // namespace rt
