// origin: invented: |x| + |y| for the larger of |x| and |y|
// caught by: the side is h, from -h/2 to h/2 (MRT §6)
// sentence: You compare |x| + |y| with h / 2: that is a square that stands on its corner. |x| and |y| are compared one by one.
#include <algorithm>
#include <cmath>
#include "common/math/vector.hpp"
#include "steps/step06_square/square.hpp"
namespace rt {
std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3& Z = square.basis.z;
    const Real facing = dot(ray.direction, Z);
    if (square.one_sided && facing >= 0) return {};
    if (facing == 0) return {};
    const Vec3 from = ray.origin - square.center;
    const Real t = -dot(from, Z) / facing;
    if (!interval.contains(t)) return {};
    const Vec3 p = from + t * ray.direction;
    const Real half = square.side / 2;
    if (!(std::fabs(dot(p, square.basis.x)) + std::fabs(dot(p, square.basis.y)) <= half)) return {};

    return t;
}
Vec2 square_uv(const Square& square, Vec3 point) {
    const Vec3 corner = square.center - square.side / 2 * (square.basis.x + square.basis.y);
    const Vec3 q = point - corner;
    return {dot(q, square.basis.x) / square.side, dot(q, square.basis.y) / square.side};
}
Vec3 normal(const Square& square, Vec3) {
    return square.basis.z;
}
}  // namespace rt
