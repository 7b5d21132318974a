// origin: CR §4.1, seen in student repositories: w0 + w1 + w2 ≤ 1
// caught by: rays aimed at a point inside meet it there (MRT §5, M1)
// sentence: Your areas have no sign and must sum to 1 at most. Inside they sum to 1, and rounding decides: salt and pepper.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    const auto area = [](Vec3 u, Vec3 v) { return length(cross(u, v)); };
    const Real sum = (area(b - p, c - p) + area(c - p, a - p) + area(a - p, b - p)) / length(n);
    if (!(sum <= 1)) return std::nullopt;
    return t;
}

}  // namespace rt
