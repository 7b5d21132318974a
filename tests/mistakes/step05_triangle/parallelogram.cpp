// origin: invented: β ≤ 1 and γ ≤ 1 for β + γ ≤ 1
// caught by: a ray to the inside hits the triangle, a ray beside it misses (MRT §5)
// sentence: You test β ≤ 1 and γ ≤ 1 one by one: that is a parallelogram. Their sum must not exceed 1.
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
    const Vec3 w = barycentric(triangle, p);
    if (!(w.y >= 0 && w.y <= 1 && w.z >= 0 && w.z <= 1)) return std::nullopt;
    return t;
}

}  // namespace rt
