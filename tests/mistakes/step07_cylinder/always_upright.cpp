// origin: seen in student repositories: y for the axis
// caught by: the axis may point anywhere (MRT §7)
// sentence: You take y for the axis of every shape. Take ⟨p − o, Z⟩.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    Cylinder upright = cylinder;
    upright.axis = {0, 1, 0};
    return correct_intersect(ray, upright, interval);
}

}  // namespace rt
