// origin: seen in student repositories: t > 0.001
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You drop hits at small t. t counts in the length of the direction, and only t ≤ 0 is dropped.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (t < Real(0.001)) return std::nullopt;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
