// right: Möller and Trumbore 1997 (M1), without an epsilon
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 u = triangle.b - triangle.a;
    const Vec3 v = triangle.c - triangle.a;
    const Vec3 q = cross(ray.direction, v);
    const Real determinant = dot(u, q);
    const Vec3 s = ray.origin - triangle.a;
    const Vec3 r = cross(s, u);
    const Real beta = dot(s, q) / determinant;
    const Real gamma = dot(ray.direction, r) / determinant;
    const Real t = dot(v, r) / determinant;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && interval.contains(t)))
        return std::nullopt;
    return t;
}

}  // namespace rt
