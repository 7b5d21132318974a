// Places on shapes of every kind.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "common/math/vector.hpp"

#include "tests/kit/random.hpp"

#include <cmath>
#include <optional>

namespace rt {

/// A shape about as large as 1, a point of it, the normal there, and a point well inside of it
/// unless it is flat.
template <class Shape>
struct Spot {
    Shape shape;
    Vec3 point;
    Vec3 normal;
    std::optional<Vec3> inside;
};

/// 10 to a power between the two.
inline Real spread(Random& random, Real low, Real high) {
    return std::pow(Real(10), random.between(low, high));
}

inline Spot<Sphere> draw(Random& random, const Sphere& /*kind*/) {
    const Sphere sphere{.center = random.point(1), .radius = random.between(Real(0.3), 1)};
    const Vec3 normal = random.direction();
    return {.shape = sphere,
            .point = sphere.center + sphere.radius * normal,
            .normal = normal,
            .inside = sphere.center + sphere.radius / 2 * random.point(1)};
}

inline Spot<Plane> draw(Random& random, const Plane& /*kind*/) {
    const Basis basis = random.basis();
    const Plane plane{.point = random.point(1), .normal = spread(random, -1, 1) * basis.z};
    return {.shape = plane,
            .point = plane.point + spread(random, -2, 2) * basis.x,
            .normal = basis.z,
            .inside = {}};
}

/// Down to slivers a thousand times longer than wide.
inline Spot<Triangle> draw(Random& random, const Triangle& /*kind*/) {
    const auto [x, y, z] = random.basis();
    const Vec3 a = random.point(1);
    const Vec3 c = a + random.between(0, 1) * x;
    const Triangle triangle{.a = a, .b = a + x, .c = c + spread(random, -3, 0) * y};
    const Real beta = random.between(Real(0.05), Real(0.9));
    const Real gamma = random.between(Real(0.05), Real(0.9)) * (1 - beta);
    return {.shape = triangle,
            .point = a + beta * (triangle.b - a) + gamma * (triangle.c - a),
            .normal = z,
            .inside = {}};
}

inline Spot<Square> draw(Random& random, const Square& /*kind*/) {
    const Square square{
        .center = random.point(1), .basis = random.basis(), .side = random.between(Real(0.5), 2)};
    const Real x = random.between(Real(-0.45), Real(0.45)) * square.side;
    const Real y = random.between(Real(-0.45), Real(0.45)) * square.side;
    return {.shape = square,
            .point = square.center + x * square.basis.x + y * square.basis.y,
            .normal = square.basis.z,
            .inside = {}};
}

inline Spot<Cylinder> draw(Random& random, const Cylinder& /*kind*/) {
    const auto [x, y, z] = random.basis();
    const Cylinder cylinder{.center = random.point(1),
                            .axis = z,
                            .radius = random.between(Real(0.2), 1),
                            .height = random.between(Real(0.5), 3)};
    const Vec3 off_axis =
        cylinder.radius / 2 * (random.between(-1, 1) * x + random.between(-1, 1) * y);
    const Real height = random.between(Real(-0.45), Real(0.45)) * cylinder.height;
    const Real inside = random.between(Real(-0.45), Real(0.45)) * cylinder.height;
    return {.shape = cylinder,
            .point = cylinder.center + cylinder.radius * x + height * z,
            .normal = x,
            .inside = cylinder.center + off_axis + inside * z};
}

inline Spot<Cone> draw(Random& random, const Cone& /*kind*/) {
    const auto [x, y, z] = random.basis();
    const Cone cone{.apex = random.point(1),
                    .axis = z,
                    .radius = random.between(Real(0.2), 1),
                    .height = random.between(Real(0.5), 3)};
    const Vec3 off_axis = cone.radius / 2 * (random.between(-1, 1) * x + random.between(-1, 1) * y);
    const Real share = random.between(Real(0.05), Real(0.95));
    const Real inside = random.between(Real(0.2), Real(0.95));
    return {.shape = cone,
            .point = cone.apex + share * (cone.height * z + cone.radius * x),
            .normal = unit(cone.height * x - cone.radius * z),
            .inside = cone.apex + inside * (cone.height * z + off_axis)};
}

inline Spot<OrientedBox> draw(Random& random, const OrientedBox& /*kind*/) {
    const Basis basis = random.basis();
    const Real u = random.between(Real(0.2), 1);
    const Real v = random.between(Real(0.2), 1);
    const Real w = random.between(Real(0.2), 1);
    const OrientedBox box{.center = random.point(1), .basis = basis, .half_size = {u, v, w}};
    const auto place = [&box](Vec3 p) {
        const Vec3 q = p * box.half_size;
        return box.center + q.x * box.basis.x + q.y * box.basis.y + q.z * box.basis.z;
    };
    Vec3 on_face = Real(0.95) * random.point(1);
    const int axis = random.below(3);
    const Real side = random.coin() ? 1 : -1;
    on_face[axis] = side;
    const Vec3 axes[] = {basis.x, basis.y, basis.z};
    return {.shape = box,
            .point = place(on_face),
            .normal = side * axes[axis],
            .inside = place(random.point(Real(0.5)))};
}

}  // namespace rt
