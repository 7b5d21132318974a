// right: HAI's u and v from the corner
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 n = square.basis.z;
    if (square.one_sided && dot(ray.direction, n) >= 0) return std::nullopt;
    const Real t = -dot(n, ray.origin - square.center) / dot(n, ray.direction);
    if (!interval.contains(t)) return std::nullopt;
    const Vec2 uv = square_uv(square, at(ray, t));
    if (!(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1)) return std::nullopt;
    return t;
}

}  // namespace rt
