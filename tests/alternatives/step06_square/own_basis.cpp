// right: MRT §6 as printed, with ≤, and abs without std::
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Real approach = dot(ray.direction, square.basis.z);
    if (square.one_sided && approach >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, square.basis.z) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    if (!(abs(dot(p, square.basis.x)) <= square.side / 2)) return std::nullopt;
    if (!(abs(dot(p, square.basis.y)) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
