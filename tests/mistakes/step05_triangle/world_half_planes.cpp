// origin: invented: the sign of the z component for that of the scalar product
// caught by: it is met from either side, whichever way its corners turn (MRT §5)
// sentence: You look at one component of (b − a) ∧ (p − a). Its sign counts along n, whichever way n points.
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
    if (!(cross(b - a, p - a).z >= 0 && cross(c - b, p - b).z >= 0 && cross(a - c, p - c).z >= 0))
        return std::nullopt;
    return t;
}

}  // namespace rt
