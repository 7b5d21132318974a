// origin: invented: 0 / 0 taken for a hit
// caught by: a parallel ray misses, above the plane and in it (MRT §4)
// sentence: A ray that runs in the plane has 0 / 0 for t. That is no hit.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real approach = dot(ray.direction, plane.normal);
    if (approach == 0) return Real(1);
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
