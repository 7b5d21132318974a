#include "steps/step06_square/square.hpp"

#include <cmath>

namespace rt {

namespace {

/// The coordinates of v along the axes of the basis (MRT §6: x = ⟨v, X⟩, …).
Vec3 in_frame(const Basis& basis, Vec3 v) {
    return {dot(v, basis.x), dot(v, basis.y), dot(v, basis.z)};
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 o = in_frame(square.basis, ray.origin - square.center);
    const Vec3 d = in_frame(square.basis, ray.direction);
    if (square.one_sided && !(d.z < 0)) return std::nullopt;

    // t = −o.z / d.z, and |o.x + t d.x| ≤ h/2 multiplied by |d.z|: deciding before dividing
    // needs no epsilon, and a grazing ray is as good as any other.
    const Real limit = square.side / 2 * std::abs(d.z);
    const bool inside =
        std::abs(o.x * d.z - o.z * d.x) <= limit && std::abs(o.y * d.z - o.z * d.y) <= limit;
    if (!inside) return std::nullopt;  // NaN must miss

    const Real t = -o.z / d.z;
    if (!interval.contains(t)) return std::nullopt;  // a ray in the square's plane has t NaN
    return t;
}

Vec2 square_uv(const Square& square, Vec3 point) {
    const Vec3 p = in_frame(square.basis, point - square.center) / square.side;
    return Vec2(p) + Real(0.5);
}

Vec3 normal(const Square& square, Vec3 /*point*/) {
    return square.basis.z;
}

}  // namespace rt
