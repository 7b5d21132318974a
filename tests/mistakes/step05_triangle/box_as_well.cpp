// origin: a student's: the box around the corners tested first
// caught by: rays aimed at a point inside meet it there (MRT §5, M1)
// sentence: You first test whether p lies in the box around the corners. If all of them are at one height, the box is flat, and a rounding of p decides: the triangle has holes. The three half-planes are enough.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const auto t = correct_intersect(ray, triangle, interval);
    if (!t) return std::nullopt;
    const Vec3 p = at(ray, *t);
    const Vec3 low = min(a, min(b, c));
    const Vec3 high = max(a, max(b, c));
    for (int i = 0; i < 3; ++i)
        if (p[i] < low[i] || p[i] > high[i]) return std::nullopt;
    return t;
}

}  // namespace rt
