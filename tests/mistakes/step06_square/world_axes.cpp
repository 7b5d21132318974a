// origin: seen in student repositories
// caught by: x and y are the square's own, not the world's (MRT §6)
// sentence: You compare the world's x and y: a square that stands or turns is cut off by the wrong axes.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = p.x;
    const Real y = p.y;
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
