// origin: invented: the nearest hit so far is ignored
// caught by: only hits strictly inside the interval count (contract)
// sentence: You compare t with 0 only. Only hits strictly inside the interval count, between its min and its max.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!(t > 0 && t < infinity)) return std::nullopt;
    return t;
}

}  // namespace rt
