// origin: invented: the plane's equation with d = point.y
// caught by: any point of the plane will do (MRT §4)
// sentence: You use one coordinate of the plane's point: the distance is ⟨o − o_r, n⟩, all three.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = (plane.point.y - ray.origin.y) / ray.direction.y;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
