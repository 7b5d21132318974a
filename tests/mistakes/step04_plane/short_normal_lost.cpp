// origin: a student's: an epsilon on ‖n‖²
// caught by: the normal is the plane's, with unit length (PHY, situation A)
// sentence: You call a short normal none: a plane's normal may have any length but 0.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    if (dot(plane.normal, plane.normal) < Real(1e-6)) return std::nullopt;
    return correct_intersect(ray, plane, interval);
}

}  // namespace rt
