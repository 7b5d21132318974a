// origin: GLM's gtx/intersect, called in place of one's own
// caught by: behind the origin, nothing is met (MRT §4–5, t positive)
// sentence: GLM's intersectRayTriangle also returns true for a triangle behind the ray: t must be positive.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval) {
    Vec2 weights;
    Real t = 0;
    if (!glm::intersectRayTriangle(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c,
                                   weights, t))
        return std::nullopt;
    return t;
}

}  // namespace rt
