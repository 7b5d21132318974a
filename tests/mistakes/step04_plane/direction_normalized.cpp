// origin: invented: t in the length of a direction made unit
// caught by: t counts in the length of the direction (PHY, any v)
// sentence: You normalize the direction: t counts in the length that the direction has.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t =
        dot(plane.point - ray.origin, plane.normal) / dot(unit(ray.direction), plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
