// origin: common in student repositories: t > 1e-4 against "shadow acne"
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You compare t with a constant above 0. t counts in the length of the direction and may be of any size: only the interval decides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Real approach = dot(ray.direction, square.basis.z);
    if (square.one_sided && approach >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, square.basis.z) / approach;
    if (!interval.contains(t) || t <= Real(1e-4)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    if (!(std::abs(dot(p, square.basis.x)) <= square.side / 2)) return std::nullopt;
    if (!(std::abs(dot(p, square.basis.y)) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
