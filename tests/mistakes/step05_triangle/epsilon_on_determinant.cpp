// origin: seen in student repositories: |det| < 1e-6 (Möller, Trumbore 1997)
// caught by: small triangles are seen: there is no epsilon (MRT §5)
// sentence: A determinant less than a constant counts as parallel, as in GLM's intersectRayTriangle. The determinant grows with the triangle's area: small triangles are lost. Compare it with 0.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 u = triangle.b - triangle.a;
    const Vec3 v = triangle.c - triangle.a;
    const Vec3 q = cross(ray.direction, v);
    const Real determinant = dot(u, q);
    if (std::abs(determinant) < Real(1e-6)) return std::nullopt;
    const Vec3 s = ray.origin - triangle.a;
    const Real beta = dot(s, q) / determinant;
    const Real gamma = dot(ray.direction, cross(s, u)) / determinant;
    const Real t = dot(v, cross(s, u)) / determinant;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && interval.contains(t)))
        return std::nullopt;
    return t;
}

}  // namespace rt
