// right: a one-sided square is seen from its front if the ray starts there
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const auto& [x, y, z] = square.basis;
    const Vec3 o = ray.origin - square.center;
    if (square.one_sided && !(dot(o, z) > 0)) return std::nullopt;
    const Real t = -dot(o, z) / dot(ray.direction, z);
    const Vec3 p = o + t * ray.direction;
    const bool inside =
        std::abs(dot(p, x)) <= square.side / 2 && std::abs(dot(p, y)) <= square.side / 2;
    return inside && interval.contains(t) ? std::optional(t) : std::nullopt;
}

}  // namespace rt
