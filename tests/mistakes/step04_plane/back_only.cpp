// origin: invented: the comparison the wrong way round
// caught by: a plane is met from either side (MRT §4)
// sentence: You see the plane only from behind. It has two sides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    if (dot(ray.direction, plane.normal) <= 0) return std::nullopt;
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
