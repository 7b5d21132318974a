// origin: invented: the nearest hit so far is ignored
// caught by: only hits strictly inside the interval count (contract)
// sentence: You compare t with 0 only. Only hits strictly inside the interval count, between its min and its max.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!(t > 0 && t < infinity)) return std::nullopt;
    const Vec3 p = at(ray, t);
    if (!(dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
          dot(cross(a - c, p - c), n) >= 0))
        return std::nullopt;
    return t;
}

}  // namespace rt
