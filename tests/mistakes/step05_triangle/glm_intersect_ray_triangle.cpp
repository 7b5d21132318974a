// origin: GLM's gtx/intersect, called in place of one's own
// caught by: small triangles are seen: there is no epsilon (MRT §5)
// sentence: A determinant less than a constant counts as parallel, as in GLM's intersectRayTriangle. The determinant grows with the triangle's area: small triangles are lost. Compare it with 0.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    Vec2 weights;
    Real t = 0;
    const Real scale = length(ray.direction);
    if (!glm::intersectRayTriangle(ray.origin, ray.direction / scale, triangle.a, triangle.b,
                                   triangle.c, weights, t))
        return std::nullopt;
    t /= scale;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
