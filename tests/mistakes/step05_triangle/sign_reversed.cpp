// origin: CR eq. (2)-(3), erratum 11
// caught by: a ray to the inside hits the triangle, a ray beside it misses (MRT §5)
// sentence: Your t has the wrong sign: it is ⟨a − o, n⟩ over ⟨d, n⟩.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(ray.origin - a, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    if (!(dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
          dot(cross(a - c, p - c), n) >= 0))
        return std::nullopt;
    return t;
}

}  // namespace rt
