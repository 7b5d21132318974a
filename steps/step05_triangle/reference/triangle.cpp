#include "steps/step05_triangle/triangle.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The coordinate system in which the ray starts at the origin and runs along z: its axes are those
/// of the world, permuted so that the direction is longest along z, with x and y sheared by the
/// slopes.
struct RayFrame {
    explicit RayFrame(const Ray& ray) : origin(ray.origin) {
        const Vec3& d = ray.direction;
        const Vec3 size(std::fabs(d.x), std::fabs(d.y), std::fabs(d.z));
        z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        slope = {d[x] / d[z], d[y] / d[z]};
    }

    /// A shared vertex gets the same bits in each of its triangles; this prevents cracks.
    [[nodiscard]] Vec3 operator()(const Vec3& vertex) const {
        const Real depth = vertex[z] - origin[z];
        return {std::fma(-slope.x, depth, vertex[x] - origin[x]),
                std::fma(-slope.y, depth, vertex[y] - origin[y]), depth};
    }

    const Vec3& origin;
    glm::length_t x;
    glm::length_t y;
    glm::length_t z;
    Vec2 slope;
};

/// The larger of |x| and |y|.
Real reach(Vec3 seen) {
    return glm::max(std::fabs(seen.x), std::fabs(seen.y));
}

/// Twice the signed area of the triangle formed by the ray and the edge from p to q. Its sign is
/// exactly opposite for the edge from q to p.
Real edge_function(Vec2 p, Vec2 q) {
    return difference_of_products(p.x, q.y, p.y, q.x);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    // Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection": the half-planes of MRT §5
    // after a change of coordinates in which the ray is the z axis. The side of an edge is then
    // consistent for all triangles, and a ray through a shared edge or vertex hits at least one of
    // its triangles.
    const RayFrame seen(ray);
    const Vec3 a = seen(triangle.a);
    const Vec3 b = seen(triangle.b);
    const Vec3 c = seen(triangle.c);

    // Areas are products of lengths, and would leave the range of float at sizes of 1e-20 and 1e20:
    // they are computed in units of the triangle's size as seen along the ray, a power of two, so
    // that scaling is exact.
    const Real scale = 1 / power_of_two_below(glm::max(reach(a), glm::max(reach(b), reach(c))));
    const Vec2 a_seen = scale * Vec2(a);
    const Vec2 b_seen = scale * Vec2(b);
    const Vec2 c_seen = scale * Vec2(c);
    const Real alpha = edge_function(b_seen, c_seen);  // opposite to a, therefore the weight of a
    const Real beta = edge_function(c_seen, a_seen);
    const Real gamma = edge_function(a_seen, b_seen);
    const bool left = glm::min(alpha, glm::min(beta, gamma)) >= 0;  // "or on": edges belong
    const bool right = glm::max(alpha, glm::max(beta, gamma)) <= 0;
    if (!left && !right) return std::nullopt;

    // α a.z + β b.z + γ c.z divided by their sum, but relative to a: then only that part rounds in
    // the distance.
    const Real depth = a.z + (beta * (b.z - a.z) + gamma * (c.z - a.z)) / (alpha + beta + gamma);
    const Real t = depth / ray.direction[seen.z];
    if (!interval.contains(t)) return std::nullopt;  // NaN must miss: seen edge-on, t is 0 / 0
    return t;
}

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    // Signed areas divided by the whole: M1's and CR's ratios, but negative outside, so their sum
    // is 1. Products of four lengths stay in range in units of the triangle's own size.
    const auto& [a, b, c] = triangle;
    const Real length_unit =
        power_of_two_below(glm::max(largest_component(b - a), largest_component(c - a)));
    const auto way = [length_unit](Vec3 from, Vec3 to) { return (to - from) / length_unit; };
    const Vec3 n = cross(way(a, b), way(a, c));
    const Vec3 areas(dot(n, cross(way(b, c), way(b, point))),
                     dot(n, cross(way(c, a), way(c, point))),
                     dot(n, cross(way(a, b), way(a, point))));
    return areas / dot(n, n);
}

Vec3 normal(const Triangle& triangle, Vec3 /*point*/) {
    // (b − a) × (c − a) = (c − b) × (a − b) = (a − c) × (b − c). At the corner opposite to the
    // longest edge, both edges are short: at a corner that is far away they might round to the same
    // vector. Each is scaled to unit length first: their product would leave the range of float at
    // 1e-20.
    const auto& [a, b, c] = triangle;
    const Real opposite_a = largest_component(c - b);
    const Real opposite_b = largest_component(a - c);
    const Real opposite_c = largest_component(b - a);
    if (opposite_a >= glm::max(opposite_b, opposite_c))
        return unit(cross(unit(b - a), unit(c - a)));
    if (opposite_b >= opposite_c) return unit(cross(unit(c - b), unit(a - b)));
    return unit(cross(unit(a - c), unit(b - c)));
}

}  // namespace rt
