// origin: seen in student repositories
// caught by: behind the origin, nothing is met (MRT §4, t positive)
// sentence: You do not test whether t is positive: the plane behind the eye is seen.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!(t < interval.max && t > -infinity)) return std::nullopt;
    return t;
}

}  // namespace rt
