// right: a x + b y + c z + d = 0 (PHY)
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Vec3 n = unit(plane.normal);
    const Real d = -dot(n, plane.point);
    const Real approach = dot(n, ray.direction);
    if (approach == 0) return std::nullopt;
    const Real t = -(dot(n, ray.origin) + d) / approach;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
