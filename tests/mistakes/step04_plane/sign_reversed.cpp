// origin: CR eq. (2)-(3), erratum 11
// caught by: situation A: t = 0.5333 at (1.467, -1.933, -0.6) (PHY)
// sentence: Your t has the wrong sign: CR writes p = o − a where a − o is meant. Points ahead seem behind.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(ray.origin - plane.point, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
