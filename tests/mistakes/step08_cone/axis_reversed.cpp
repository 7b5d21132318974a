// origin: invented: the axis from the base to the apex
// caught by: it opens along the axis, from the apex to the height (MRT §8)
// sentence: Your cone opens against the axis. Z points from the apex into the cone.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    Cone rotated = cone;
    rotated.axis = -cone.axis;
    return correct_intersect(ray, rotated, interval);
}

}  // namespace rt
