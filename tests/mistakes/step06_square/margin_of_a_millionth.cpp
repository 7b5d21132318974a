// origin: derived: |x| ≤ h / 2 + 1e-6
// caught by: small squares and short directions count: no epsilon on ⟨d, Z⟩ (contract)
// sentence: You add a constant to h / 2: a small square becomes much larger.
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
    if (!(std::abs(dot(p, square.basis.x)) <= square.side / 2 + Real(1e-6))) return std::nullopt;
    if (!(std::abs(dot(p, square.basis.y)) <= square.side / 2 + Real(1e-6))) return std::nullopt;
    return t;
}

}  // namespace rt
