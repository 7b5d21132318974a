#include "tests/oracle/distances.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace rt::oracle {

namespace {

/// Across an axis and along it, in its length's units.
struct Section {
    Number radius;
    Number height;
};

Section section(const ExactVector& v, const ExactVector& axis) {
    const Number unit = length(axis);
    return {.radius = length(cross(v, axis)) / unit, .height = dot(v, axis).number() / unit};
}

Number distance(const NumberVector& p, const NumberVector& q) {
    const NumberVector v = p - q;
    return sqrt(dot(v, v));
}

/// From the ray to the segment from p to q.
Number distance(const NumberVector& o, const NumberVector& d, const NumberVector& p,
                const NumberVector& q) {
    // The closest points, s along the segment and t along the ray, each in its range.
    const NumberVector e = q - p;
    const NumberVector w = p - o;
    const Number dd = dot(d, d);
    const Number ee = dot(e, e);
    const Number de = dot(d, e);
    const Number whole = dd * ee - de * de;
    const auto within = [](const Number& x) { return std::clamp(x, Number(0), Number(1)); };
    Number s = whole > 0 ? within(Number((de * dot(w, d) - dd * dot(w, e)) / whole)) : Number(0);
    Number t = (dot(w, d) + s * de) / dd;
    if (t < 0) {
        t = 0;
        s = ee > 0 ? within(Number(-dot(w, e) / ee)) : Number(0);
    }
    return distance(p + s * e, o + t * d);
}

/// From the ray to the edges between the corners, one after the other and round.
Number distance_to_edges(const Ray& ray, std::initializer_list<NumberVector> corners) {
    const NumberVector o = number(ray.origin);
    const NumberVector d = number(ray.direction);
    NumberVector from = *(corners.end() - 1);
    Number nearest = -1;
    for (const NumberVector& corner : corners) {
        const Number next = distance(o, d, from, corner);
        if (nearest < 0 || next < nearest) nearest = next;
        from = corner;
    }
    return nearest;
}

/// How far the point is beyond the faces along each axis of the box; negative inside.
std::array<Number, 3> beyond_faces(const ExactVector& point, const OrientedBox& box) {
    const auto beyond = [&](const ExactVector& axis, const Exact& half) {
        const Number place = dot(point - box.center, axis).number();
        return Number((abs(place) - half.number()) / length(axis));
    };
    return {beyond(box.x, box.half_size.x), beyond(box.y, box.half_size.y),
            beyond(box.z, box.half_size.z)};
}

/// From a point to the box and its inside.
Number outside(const std::array<Number, 3>& beyond) {
    Number squares = 0;
    for (const Number& way : beyond)
        if (way > 0) squares += way * way;
    return sqrt(squares);
}

}  // namespace

Number off_surface(const ExactVector& point, const Sphere& sphere) {
    const ExactVector v = point - sphere.center;
    const Number square = (dot(v, v) - squared(sphere.radius)).number();
    return abs(square) / (length(v) + sphere.radius.number());
}

Number off_surface(const ExactVector& point, const Plane& plane) {
    return abs(dot(point - plane.point, plane.normal).number()) / length(plane.normal);
}

Number off_surface(const ExactVector& point, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return off_surface(point, Plane{.point = a, .normal = cross(b - a, c - a)});
}

Number off_surface(const ExactVector& point, const Square& square) {
    return off_surface(point, Plane{.point = square.center, .normal = square.z});
}

Number off_surface(const ExactVector& point, const Cylinder& cylinder) {
    return abs(section(point - cylinder.center, cylinder.axis).radius - cylinder.radius.number());
}

Number off_surface(const ExactVector& point, const Cone& cone) {
    const auto [radius, height] = section(point - cone.apex, cone.axis);
    const Number slant = sqrt((squared(cone.radius) + squared(cone.height)).number());
    return abs(radius * cone.height.number() - abs(height) * cone.radius.number()) / slant;
}

Number off_surface(const ExactVector& point, const OrientedBox& box) {
    const auto beyond = beyond_faces(point, box);
    const Number most = *std::ranges::max_element(beyond);
    return most < 0 ? Number(-most) : outside(beyond);
}

Number gap(const Ray& ray, const ExactVector& /*near*/, const Sphere& sphere) {
    const ExactVector v = sphere.center - ray.origin;
    if (dot(v, ray.direction).sign() <= 0) return length(v) - sphere.radius.number();
    return length(cross(v, ray.direction)) / length(ray.direction) - sphere.radius.number();
}

Number gap(const Ray& /*ray*/, const ExactVector& near, const Plane& plane) {
    return off_surface(near, plane);
}

Number gap(const Ray& ray, const ExactVector& /*near*/, const Triangle& triangle) {
    return distance_to_edges(ray, {number(triangle.a), number(triangle.b), number(triangle.c)});
}

Number gap(const Ray& ray, const ExactVector& /*near*/, const Square& square) {
    // The corners where the four planes of its sides meet its own, by Cramer's rule.
    const Number half = square.side.number() / 2;
    const Number whole = dot(square.x, cross(square.y, square.z)).number();
    const NumberVector x = Number(half / whole) * number(cross(square.y, square.z));
    const NumberVector y = Number(half / whole) * number(cross(square.z, square.x));
    const NumberVector c = number(square.center);
    return distance_to_edges(ray, {c - x - y, c + x - y, c + x + y, c - x + y});
}

Number gap(const Ray& /*ray*/, const ExactVector& near, const Cylinder& cylinder) {
    const auto [radius, height] = section(near - cylinder.center, cylinder.axis);
    const Number across = radius - cylinder.radius.number();
    const Number along = std::max(Number(0), Number(abs(height) - cylinder.height.number() / 2));
    return sqrt(across * across + along * along);
}

Number gap(const Ray& /*ray*/, const ExactVector& near, const Cone& cone) {
    const auto [radius, height] = section(near - cone.apex, cone.axis);
    const Number r = cone.radius.number();
    const Number h = cone.height.number();
    // The closest point of the side, seen edge-on: a fraction of the way from apex to rim.
    const Number share =
        std::clamp(Number((radius * r + height * h) / (r * r + h * h)), Number(0), Number(1));
    const Number across = radius - share * r;
    const Number along = height - share * h;
    return sqrt(across * across + along * along);
}

Number gap(const Ray& /*ray*/, const ExactVector& near, const OrientedBox& box) {
    return outside(beyond_faces(near, box));
}

}  // namespace rt::oracle
