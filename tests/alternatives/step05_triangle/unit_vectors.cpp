// right: MRT §5 with a unit normal and a unit direction
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = glm::normalize(cross(b - a, c - a));
    const Vec3 d = glm::normalize(ray.direction);
    const Real slope = dot(n, d);
    if (slope == 0) return std::nullopt;
    const Real distance = dot(n, a - ray.origin) / slope;
    const Real t = distance / glm::length(ray.direction);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = ray.origin + distance * d;
    if (!(dot(cross(b - a, p - a), n) >= 0)) return std::nullopt;
    if (!(dot(cross(c - b, p - b), n) >= 0)) return std::nullopt;
    if (!(dot(cross(a - c, p - c), n) >= 0)) return std::nullopt;
    return t;
}

}  // namespace rt
