#include "common/scene/surface_points.hpp"

#include "common/geometry/bounds.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

/// A unit vector perpendicular to the axis, rotated around it by `turn` of a full turn.
Vec3 around(Vec3 axis, Real turn) {
    const Vec3 aside = std::abs(axis.x) < Real(0.6) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 x = unit(cross(axis, aside));
    return std::cos(2 * pi * turn) * x + std::sin(2 * pi * turn) * cross(axis, x);
}

/// A point in the half-plane of a surface of revolution: its coordinates from the axis and along
/// it.
struct Meridian {
    Real across;
    Real along;
};

Meridian meridian(Vec3 from_center, Vec3 axis) {
    return {.across = length(cross(from_center, axis)), .along = dot(from_center, axis)};
}

Real distance_to_segment(Vec3 point, Vec3 a, Vec3 b) {
    const Vec3 ab = b - a;
    const Real square = dot(ab, ab);
    const Real part = square > 0 ? glm::clamp(dot(point - a, ab) / square, Real(0), Real(1)) : 0;
    return length(point - (a + part * ab));
}

}  // namespace

Real size(const Sphere& sphere) {
    return sphere.radius;
}

Real size(const Triangle& triangle) {
    // Twice the area divided by the longest side: the smallest height.
    const Vec3 ab = triangle.b - triangle.a;
    const Vec3 ac = triangle.c - triangle.a;
    const Real longest = std::max({length(ab), length(ac), length(ac - ab)});
    return longest > 0 ? length(cross(ab, ac)) / longest : 0;
}

Real size(const Square& square) {
    return square.side;
}

Real size(const Cylinder& cylinder) {
    return std::min(cylinder.radius, cylinder.height);
}

Real size(const Cone& cone) {
    return std::min(cone.radius, cone.height);
}

Real size(const OrientedBox& box) {
    return 2 * std::min({box.half_size.x, box.half_size.y, box.half_size.z});
}

Real size(const MeshInstance& instance) {
    const BoundingBox& box = instance.model->bounds;
    const auto triangles = Real(instance.model->mesh.triangles.size());
    return instance.placement.scale * length(box.max - box.min) / std::sqrt(triangles + 1);
}

Vec3 point_of(const Sphere& sphere, Vec2 place) {
    const Real z = 1 - 2 * place.y;
    const Real across = std::sqrt(std::max(1 - z * z, Real(0)));
    const Real angle = 2 * pi * place.x;
    return sphere.center +
           sphere.radius * Vec3(across * std::cos(angle), across * std::sin(angle), z);
}

Vec3 point_of(const Triangle& triangle, Vec2 place) {
    if (place.x + place.y > 1) place = Vec2(1) - place;
    const auto& [a, b, c] = triangle;
    return a + place.x * (b - a) + place.y * (c - a);
}

Vec3 point_of(const Square& square, Vec2 place) {
    const Vec2 from_middle = place - Vec2(Real(0.5));
    return square.center +
           square.side * (from_middle.x * square.basis.x + from_middle.y * square.basis.y);
}

Vec3 point_of(const Cylinder& cylinder, Vec2 place) {
    return cylinder.center + (place.y - Real(0.5)) * cylinder.height * cylinder.axis +
           cylinder.radius * around(cylinder.axis, place.x);
}

Vec3 point_of(const Cone& cone, Vec2 place) {
    const Vec3 to_rim = cone.height * cone.axis + cone.radius * around(cone.axis, place.x);
    return cone.apex + std::sqrt(place.y) * to_rim;
}

Vec3 point_of(const OrientedBox& box, Vec2 place) {
    const auto& [x, y, z] = box.basis;
    // The index of the face, and the position in it.
    const auto face = std::min(int(6 * place.x), 5);
    const Real part = 6 * place.x - Real(face);
    const Real side = face % 2 == 0 ? -1 : 1;
    Vec3 in_box(2 * part - 1, 2 * place.y - 1, side);
    if (face / 2 == 0) in_box = {side, in_box.x, in_box.y};
    if (face / 2 == 1) in_box = {in_box.x, side, in_box.y};
    in_box *= box.half_size;
    return box.center + in_box.x * x + in_box.y * y + in_box.z * z;
}

Vec3 point_of(const MeshInstance& instance, Vec2 place) {
    const auto& vertices = instance.model->mesh.vertices;
    if (vertices.empty()) return Vec3(std::numeric_limits<Real>::quiet_NaN());
    const auto i = std::size_t(place.x * Real(vertices.size()));
    return transformed(vertices[std::min(i, vertices.size() - 1)], instance.placement);
}

Real distance(Vec3 point, const Sphere& sphere) {
    return std::abs(length(point - sphere.center) - sphere.radius);
}

Real distance(Vec3 point, const Plane& plane) {
    return std::abs(dot(point - plane.point, unit(plane.normal)));
}

Real distance(const Plane& a, const Plane& b) {
    const bool parallel = length(cross(unit(a.normal), unit(b.normal))) < 8 * unit_roundoff;
    return parallel ? distance(a.point, b) : infinity;
}

Real distance(Vec3 point, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const bool inside = dot(cross(b - a, point - a), n) >= 0 &&
                        dot(cross(c - b, point - b), n) >= 0 &&
                        dot(cross(a - c, point - c), n) >= 0;
    if (inside && n != Vec3(0)) return std::abs(dot(point - a, unit(n)));
    return std::min({distance_to_segment(point, a, b), distance_to_segment(point, b, c),
                     distance_to_segment(point, c, a)});
}

Real distance(Vec3 point, const Square& square) {
    const Vec3 from_center = point - square.center;
    const auto beyond = [&](Vec3 axis) {
        return std::max(std::abs(dot(from_center, axis)) - square.side / 2, Real(0));
    };
    return length(
        Vec3(beyond(square.basis.x), beyond(square.basis.y), dot(from_center, square.basis.z)));
}

Real distance(Vec3 point, const Cylinder& cylinder) {
    const Meridian at = meridian(point - cylinder.center, cylinder.axis);
    return std::hypot(at.across - cylinder.radius,
                      std::max(std::abs(at.along) - cylinder.height / 2, Real(0)));
}

Real distance(Vec3 point, const Cone& cone) {
    const Meridian at = meridian(point - cone.apex, cone.axis);
    return distance_to_segment(Vec3(at.across, at.along, 0), Vec3(0),
                               Vec3(cone.radius, cone.height, 0));
}

Real distance(Vec3 point, const OrientedBox& box) {
    const Vec3 from_center = point - box.center;
    const auto& [x, y, z] = box.basis;
    const Vec3 in_box(dot(from_center, x), dot(from_center, y), dot(from_center, z));
    const Vec3 beyond = abs(in_box) - box.half_size;
    const Real outside = length(glm::max(beyond, Vec3(0)));
    return outside > 0 ? outside : -std::max({beyond.x, beyond.y, beyond.z});
}

Real distance(Vec3 /*point*/, const MeshInstance& /*placed*/) {
    return infinity;
}

}  // namespace rt
