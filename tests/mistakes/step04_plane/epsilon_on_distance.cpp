// origin: common in student repositories: a unit direction, and a distance > 1e-4
// caught by: near hits count as much as far ones: no epsilon on t (contract)
// sentence: You drop hits that are nearer than a fixed distance: only the interval decides.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const Real distance = dot(plane.point - ray.origin, plane.normal) / dot(d, plane.normal);
    if (distance < Real(1e-4) || !interval.contains(distance / speed)) return std::nullopt;
    return distance / speed;
}

}  // namespace rt
