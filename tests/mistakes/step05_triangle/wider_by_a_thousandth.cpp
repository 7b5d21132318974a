// origin: derived: β and γ from −0.001 to 1.001, so that no crack shows
// caught by: the triangle ends at its edges, and not 0.1 % further (MRT §5)
// sentence: You let the weights be a little below 0: every triangle is larger than it is. An edge belongs to it with ≥ 0, without a margin.
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
    const bool inside =
        beta >= Real(-0.001) && gamma >= Real(-0.001) && beta + gamma <= Real(1.001);
    if (!inside || !interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
