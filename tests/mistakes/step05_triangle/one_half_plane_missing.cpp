// origin: invented: the third half-plane forgotten
// caught by: each half-plane is tested (MRT §5)
// sentence: You test two half-planes of three: the triangle extends across one of its edges.
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
    if (!(dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0))
        return std::nullopt;
    return t;
}

}  // namespace rt
