// origin: invented: the box around the corners for the triangle
// caught by: a ray to the inside hits the triangle, a ray beside it misses (MRT §5)
// sentence: You test whether p lies in the box around the corners. The triangle is half of it.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include <algorithm>

#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    for (int i = 0; i < 3; ++i)
        if (p[i] < std::min({a[i], b[i], c[i]}) || p[i] > std::max({a[i], b[i], c[i]}))
            return std::nullopt;
    return t;
}

}  // namespace rt
