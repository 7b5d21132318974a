// origin: invented: t ≥ 0
// caught by: a ray that starts on the plane does not meet it (PHY, t > 0)
// sentence: You take t = 0 for a hit: a ray that leaves the plane meets it at once.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!(t >= 0 && t < interval.max)) return std::nullopt;
    return t;
}

}  // namespace rt
