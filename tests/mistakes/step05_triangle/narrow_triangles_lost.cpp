// origin: a student's: an epsilon on the sine of an angle
// caught by: narrow triangles are seen: there is no epsilon on angles or sides (contract)
// sentence: You leave out narrow triangles: only a triangle without any area is missed.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 n = cross(unit(triangle.b - triangle.a), unit(triangle.c - triangle.a));
    if (length(n) < Real(1e-3)) return std::nullopt;
    return correct_intersect(ray, triangle, interval);
}

}  // namespace rt
