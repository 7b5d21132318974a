// origin: invented: ⟨o, n⟩ for ⟨o − o_r, n⟩
// caught by: a plane is met from either side (MRT §4)
// sentence: You forget the ray's origin: the distance is ⟨o − o_r, n⟩.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
