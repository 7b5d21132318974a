// origin: derived: |⟨d, Z⟩| < 1e-9
// caught by: a grazing ray meets the square: there is no epsilon (MRT §6)
// sentence: You compare ⟨d, Z⟩ with a very small constant. It grows with the length of d: only 0 is parallel.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (std::abs(dot(ray.direction, square.basis.z)) < Real(1e-9)) return std::nullopt;
    const Real approach = dot(ray.direction, square.basis.z);
    if (square.one_sided && approach >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, square.basis.z) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    if (!(std::abs(dot(p, square.basis.x)) <= square.side / 2)) return std::nullopt;
    if (!(std::abs(dot(p, square.basis.y)) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
