// origin: MRT §5, erratum 5
// caught by: edges belong to the triangle: no crack along a quad's diagonal (erratum 5, MRT §5)
// sentence: You test > 0, as MRT §5 prints. On an edge it is 0: both neighbors miss, and a crack shows.
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
    if (!(dot(cross(b - a, p - a), n) > 0 && dot(cross(c - b, p - b), n) > 0 &&
          dot(cross(a - c, p - c), n) > 0))
        return std::nullopt;
    return t;
}

}  // namespace rt
