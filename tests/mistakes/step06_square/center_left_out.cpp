// origin: invented: ⟨p, X⟩ for ⟨p − o, X⟩
// caught by: the center counts (MRT §6)
// sentence: You take ⟨p, X⟩. MRT §6 has ⟨p − o, X⟩: from the square's center.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    const Real x = dot(p, square.basis.x);
    const Real y = dot(p, square.basis.y);
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
