// origin: invented: the nearest hit so far is ignored
// caught by: only hits strictly inside the interval count (contract)
// sentence: You compare t with 0 only. Only hits strictly inside the interval count, between its min and its max.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!(t > 0 && t < infinity)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, square.basis.x);
    const Real y = dot(p, square.basis.y);
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
