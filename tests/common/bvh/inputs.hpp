// Triangles, meshes and rays for the tests of this room, and the boxes that a ray visits.
#pragma once

#include "common/bvh/bvh.hpp"
#include "common/geometry/bounds.hpp"
#include "common/geometry/triangle.hpp"

#include "tests/kit/meshes.hpp"
#include "tests/kit/shape_checks.hpp"

#include <cmath>
#include <set>
#include <vector>

namespace rt {

/// A number with a uniform logarithm: small and large shapes alike.
inline Real size_between(Random& random, Real low, Real high) {
    return low * std::pow(high / low, random.between(0, 1));
}

inline Vec3 draw_axis(Random& random) {
    Vec3 axis(0);
    if (random.coin()) return random.direction();
    axis[random.below(3)] = random.coin() ? 1 : -1;
    return axis;
}

inline void draw(Random& random, Triangle& triangle) {
    const Vec3 a = random.point(4);
    const Real size = size_between(random, Real(0.01), 2);
    triangle = {.a = a, .b = a + size * random.direction(), .c = a + size * random.direction()};
}

/// A ray from anywhere, along an axis or in any direction, to a corner, the middle of a face or a
/// point of the box: at the points where a shape touches its box, a box too small would lose it.
inline Ray draw_ray(Random& random, const BoundingBox& box) {
    Vec3 share;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        share[axis] = random.coin() ? Real(random.below(3)) / 2 : random.between(0, 1);
    const Vec3 aim = box.min + share * (box.max - box.min);
    Vec3 away = random.coin() ? random.direction() : draw_axis(random);
    return {.origin = aim + size_between(random, Real(0.1), 100) * away,
            .direction = -random.power_of_two() * away};
}

inline Bvh hierarchy_of(const std::vector<BoundingBox>& boxes) {
    return Bvh(boxes.size(), [&boxes](std::size_t i) { return boxes[i]; });
}

inline std::set<std::uint32_t> visited(const Bvh& hierarchy, const Ray& ray, Interval interval) {
    std::set<std::uint32_t> indices;
    RayBoxTestCache slabs(ray);
    hierarchy.nearest(slabs, interval, [&](std::uint32_t index) { indices.insert(index); });
    return indices;
}

/// A closed surface of 8 · 4^times triangles around 0, between 0.8 and 1.2 from it.
inline Mesh bumpy_ball(int times) {
    Mesh mesh = octahedron();
    for (int i = 0; i < times; ++i) mesh = refined(mesh);
    for (Vec3& p : mesh.vertices)
        p *= 1 + Real(0.2) * std::sin(9 * p.x) * std::sin(7 * p.y + 1) * std::sin(8 * p.z + 2);
    return mesh;
}

inline Triangle triangle_of(const Mesh& mesh, std::size_t i) {
    const auto [a, b, c] = mesh.triangles[i];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// From inside a ball around the center, at a vertex or a point of an edge.
inline Ray draw_shot(Random& random, const Mesh& mesh, Real scale, Vec3 center) {
    const auto corners = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const auto corner = std::size_t(random.below(3));
    const Vec3 p = mesh.vertices[corners[corner]];
    const Vec3 q = mesh.vertices[corners[(corner + 1) % 3]];
    const Vec3 aim = random.coin() ? p : p + random.between(0, 1) * (q - p);
    const Vec3 origin = center + scale * random.point(Real(0.3));
    return {.origin = origin, .direction = random.power_of_two() * (aim - origin)};
}

/// A square grid of side × side cells of side 1 in the plane z = 0, from (0, 0).
inline Mesh grid(std::uint32_t side) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x) mesh.vertices.push_back({Real(x), Real(y), 0});
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t corner = y * (side + 1) + x;
            const std::uint32_t above = corner + side + 1;
            mesh.triangles.push_back({corner, corner + 1, above});
            mesh.triangles.push_back({corner + 1, above + 1, above});
        }
    return mesh;
}

}  // namespace rt
