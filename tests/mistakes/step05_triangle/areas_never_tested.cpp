// origin: CR §4.1 listing, erratum 17
// caught by: a ray to the inside hits the triangle, a ray beside it misses (MRT §5)
// sentence: You compute the areas and never test whether they sum to 1: the whole plane is hit.
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
    return t;
}

}  // namespace rt
