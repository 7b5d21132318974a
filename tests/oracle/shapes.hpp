// What the contracts of stages 3 to 8 promise of shapes, in exact arithmetic and by formulas of its
// own: a surface is a polynomial's zeros, and a shape the part of it where others have a sign.
//
// An axis or a normal is a direction, of whatever length its floats give it. A square is where its
// three coordinates in its basis say, each taken as it is.
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
    std::optional<Exact> max;  ///< none: no end
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

/// Where the ray's line crosses the whole of the plane or quadric of which the shape is a part, in
/// rising order.
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Sphere& sphere);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Plane& plane);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Triangle& triangle);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Square& square);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Cylinder& cylinder);
[[nodiscard]] std::vector<Root> roots(const Ray& ray, const Cone& cone);

/// Whether such a crossing is on the shape.
[[nodiscard]] bool belongs(const Ray& ray, const Sphere& sphere, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Plane& plane, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Triangle& triangle, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Square& square, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Cylinder& cylinder, const Root& t);
[[nodiscard]] bool belongs(const Ray& ray, const Cone& cone, const Root& t);

[[nodiscard]] bool contains(const Interval& interval, const Root& t);

/// The first of the crossings that is on the shape and strictly inside the interval.
template <class Shape>
std::optional<Root> intersect(const Ray& ray, const Shape& shape, const Interval& interval) {
    for (const Root& t : roots(ray, shape))
        if (contains(interval, t) && belongs(ray, shape, t)) return t;
    return std::nullopt;
}

/// The unit normals: outward, or to who sees a, b, c turn anticlockwise.
[[nodiscard]] NumberVector normal(const Sphere& sphere, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Plane& plane, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Triangle& triangle, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Square& square, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Cylinder& cylinder, const ExactVector& point);
[[nodiscard]] NumberVector normal(const Cone& cone, const ExactVector& point);

[[nodiscard]] NumberVector color_from_normal(const ExactVector& normal);
[[nodiscard]] Number torch(const ExactVector& point, const ExactVector& normal,
                           const ExactVector& eye);

/// The weights of a, b and c that give the point of the triangle's plane nearest to this one. The
/// triangle has an area.
[[nodiscard]] NumberVector barycentric(const Triangle& triangle, const ExactVector& point);

/// u and v of HAI.
[[nodiscard]] std::array<Number, 2> square_uv(const Square& square, const ExactVector& point);

/// The direction mirrored in the plane at right angles to the normal, of whatever length that is.
[[nodiscard]] NumberVector mirrored(const ExactVector& direction, const ExactVector& normal);

/// Whether the ray is somewhere in the box, faces included, at a t of the interval, ends included.
[[nodiscard]] bool overlap(const Ray& ray, const ExactVector& min, const ExactVector& max,
                           const Interval& interval);

}  // namespace rt::oracle
