// origin: derived: |⟨d, n⟩| < 1e-6 of unit vectors
// caught by: a grazing ray meets the triangle: there is no epsilon (MRT §5)
// sentence: You call rays parallel that are not: compare ⟨d, n⟩ with 0, or let the division decide.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    if (std::abs(dot(unit(ray.direction), unit(n))) < Real(1e-6)) return std::nullopt;
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    const bool inside = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                        dot(cross(a - c, p - c), n) >= 0;
    if (!inside) return std::nullopt;
    return t;
}

}  // namespace rt
