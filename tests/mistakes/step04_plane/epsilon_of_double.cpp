// origin: derived: |⟨d, n⟩| < 1e-15, the epsilon of double
// caught by: a grazing ray meets the plane far away: there is no epsilon (MRT §4)
// sentence: You compare ⟨d, n⟩ with a very small constant. It grows with the length of d and of n: only 0 is parallel.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    if (std::abs(dot(ray.direction, plane.normal)) < Real(1e-15)) return std::nullopt;
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
