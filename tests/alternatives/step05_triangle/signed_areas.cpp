// right: the weights of the point, none of them negative (CR §4.1 with signs)
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real approach = dot(ray.direction, n);
    if (approach == 0) return std::nullopt;
    const Real t = dot(triangle.a - ray.origin, n) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 w = barycentric(triangle, at(ray, t));
    if (!(w.x >= 0 && w.y >= 0 && w.z >= 0)) return std::nullopt;
    return t;
}

}  // namespace rt
