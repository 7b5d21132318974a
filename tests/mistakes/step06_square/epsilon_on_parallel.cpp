// origin: seen in student repositories: |d · n| < 1e-4
// caught by: a grazing ray meets the square: there is no epsilon (MRT §6)
// sentence: You call rays parallel that are not: compare ⟨d, Z⟩ with 0, or let the division decide.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    if (std::abs(dot(ray.direction, square.basis.z)) < Real(1e-4)) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, square.basis.x);
    const Real y = dot(p, square.basis.y);
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
