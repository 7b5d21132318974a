// The contracts of stages 3 to 8 about shapes, in exact arithmetic and with independent formulas: a
// surface is the zero set of a polynomial, and a shape the part of it where other polynomials have
// a sign.
//
// An axis or a normal is a direction, with the exact length of its floats. A square's points have
// exact coordinates in its basis.
#pragma once

#include "tests/oracle/root.hpp"
#include "tests/oracle/vector.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rt::oracle {

struct Ray {
    ExactVector origin;
    ExactVector direction;
};

struct Interval {
    Exact min;
    std::optional<Exact> max;  ///< empty: no end
};

struct Sphere {
    ExactVector center;
    Exact radius;
};

struct Plane {
    ExactVector point;
    ExactVector normal;
};

struct Triangle {
    ExactVector a;
    ExactVector b;
    ExactVector c;
};

struct Square {
    ExactVector center;
    ExactVector x;
    ExactVector y;
    ExactVector z;
    Exact side;
    bool one_sided = false;
};

struct Cylinder {
    ExactVector center;
    ExactVector axis;
    Exact radius;
    Exact height;
};

struct Cone {
    ExactVector apex;
    ExactVector axis;
    Exact radius;
    Exact height;
};

/// The points whose coordinates along the axes, from the center, are at most those of half_size.
struct OrientedBox {
    ExactVector center;
    ExactVector x;
    ExactVector y;
    ExactVector z;
    ExactVector half_size;
};

/// The crossings of the ray's line with the whole plane or quadric that contains the shape, in
/// ascending order; of a box, those with its faces.
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Sphere& sphere);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Plane& plane);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Triangle& triangle);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Square& square);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Cylinder& cylinder);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Cone& cone);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const OrientedBox& box);

/// True if such a crossing is on the shape.
[[nodiscard]] bool belongs(const Ray& ray, const Sphere& sphere, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Plane& plane, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Triangle& triangle, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Square& square, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Cylinder& cylinder, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Cone& cone, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const OrientedBox& box, const Root& t);

[[nodiscard]] bool contains(const Interval& interval, const Root& t);

/// The first of the crossings that is on the shape and strictly inside the interval.
template <class Shape>
std::optional<Root> intersect(const Ray& ray, const Shape& shape, const Interval& interval) {
    for (const Root& t : roots(ray, shape))
        if (contains(interval, t) && belongs(ray, shape, t)) return t;
    return std::nullopt;
}

/// The unit normals: outward, or to the side from which a, b, c are in counterclockwise order.
[[nodiscard]] NumberVector normal(const Sphere& sphere, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Plane& plane, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Triangle& triangle, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Square& square, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Cylinder& cylinder, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Cone& cone, const ExactVector& point);

[[nodiscard]] NumberVector color_from_normal(const ExactVector& normal);
[[nodiscard]] Number torch(const ExactVector& point, const ExactVector& normal,
                           const ExactVector& eye);

/// The weights of a, b and c that give the point of the triangle's plane closest to this one. The
/// triangle has an area.
[[nodiscard]] NumberVector barycentric(const Triangle& triangle, const ExactVector& point);

/// u and v of HAI.
[[nodiscard]] std::array<Number, 2> square_uv(const Square& square, const ExactVector& point);

/// The direction mirrored in the plane at right angles to the normal, for any length of the normal.
[[nodiscard]] NumberVector mirrored(const ExactVector& direction, const ExactVector& normal);

/// True if the ray is in the box, faces included, at some t of the interval, ends included.
[[nodiscard]] bool overlap(const Ray& ray, const ExactVector& min, const ExactVector& max,
                           const Interval& interval);

}  // namespace rt::oracle
