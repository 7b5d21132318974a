// origin: common in student repositories: t > 1e-4 against "shadow acne"
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You compare t with a constant above 0. t counts in the length of the direction and may be of any size: only the interval decides.
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
    const Real beta = dot(s, q) / determinant;
    const Real gamma = dot(ray.direction, cross(s, u)) / determinant;
    const Real t = dot(v, cross(s, u)) / determinant;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && interval.contains(t) && t > Real(1e-4)))
        return std::nullopt;
    return t;
}

}  // namespace rt
