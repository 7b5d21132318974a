// origin: seen in student repositories: |d · n| < 1e-6
// caught by: a grazing ray meets the plane far away: there is no epsilon (MRT §4)
// sentence: You call rays parallel that are not: compare ⟨d, n⟩ with 0, or let the division decide.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    if (std::abs(dot(ray.direction, plane.normal)) < Real(1e-6)) return std::nullopt;
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
