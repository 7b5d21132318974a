// origin: derived: |x| ≤ 1.001 h / 2, so that no crack shows
// caught by: the square ends at its edges, and not 0.1 % further (MRT §6)
// sentence: You let x and y be a little larger than h / 2: the square ends further out. Its edge belongs to it with ≤, without a margin.
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
    if (!(std::abs(dot(p, square.basis.x)) <= Real(1.001) * square.side / 2)) return std::nullopt;
    if (!(std::abs(dot(p, square.basis.y)) <= Real(1.001) * square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
