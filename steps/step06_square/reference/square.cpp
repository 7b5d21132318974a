#include "steps/step06_square/square.hpp"

#include "common/math/compensated.hpp"

#include <cmath>

namespace rt {

namespace {

/// The coordinates of v along the axes of the basis (MRT §6: x = ⟨v, X⟩, …).
Vec3 coordinates(const Basis& basis, Vec3 v) {
    return {dot(v, basis.x), dot(v, basis.y), dot(v, basis.z)};
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const auto& [x, y, z] = square.basis;
    const Vec3 o = ray.origin - square.center;
    const Vec3& d = ray.direction;
    const Real slope = dot_along(d, z);
    if (square.one_sided && !(slope < 0)) return std::nullopt;
    const Real inverse_slope = 1 / slope;
    // Relative to a point p of the ray's line that is close to the square's plane: the remaining
    // errors depend on the square's size and not on the distance of the origin. If the height of
    // the origin is little more than a rounding error, p may be far away and hardly closer to the
    // plane than the origin: then p is the origin.
    const Real height_of_o = dot(o, z);
    Real t_near = -height_of_o * inverse_slope;
    Real height = dot(fused_at(o, t_near, d), z);
    if (!(std::abs(height) <= std::abs(height_of_o) / 8)) {
        t_near = 0;
        height = height_of_o;
    }
    const Vec3 p = fused_at(o, t_near, d);
    const Real t = t_near - height * inverse_slope;
    if (!interval.contains(t)) return std::nullopt;  // a ray in the square's plane has t NaN

    // |p.x − p.z d.x / d.z| ≤ side / 2 multiplied by |d.z|, in object space: the test without the
    // rounded t needs no epsilon, and is as accurate for a grazing ray as for any other.
    const Real limit = square.side / 2 * std::abs(slope);
    const bool inside = std::abs(dot(p, x) * slope - height * dot(d, x)) <= limit &&
                        std::abs(dot(p, y) * slope - height * dot(d, y)) <= limit;
    if (!inside) return std::nullopt;  // NaN must miss
    return t;
}

Vec2 square_uv(const Square& square, Vec3 point) {
    const Vec3 p = coordinates(square.basis, point - square.center) / square.side;
    return Vec2(p) + Real(0.5);
}

Vec3 normal(const Square& square, Vec3 /*point*/) {
    return square.basis.z;
}

}  // namespace rt
