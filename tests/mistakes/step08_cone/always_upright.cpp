// origin: seen in student repositories: y for the axis
// caught by: the axis may point anywhere (MRT §8)
// sentence: You take y for the axis of every shape. Take ⟨p − o, Z⟩.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    Cone upright = cone;
    upright.axis = {0, 1, 0};
    return correct_intersect(ray, upright, interval);
}

}  // namespace rt
