// origin: invented: ⟨d, n⟩ divided by a length that is not 1
// caught by: the length and the sign of the normal do not matter for t (PHY, N and n)
// sentence: Your t depends on the length of the normal: it stands above and below the line, and cancels.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) /
                   dot(ray.direction, plane.normal / length(plane.normal));
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
