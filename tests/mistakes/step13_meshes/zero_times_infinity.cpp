// origin: course/mistakes.md
// caught by: a ray along a face or an edge is in the box, though 0 times infinity is NaN (M1)
// sentence: A ray along a face gives 0 / 0, which is NaN, and the result of std::min and std::max depends on its position. Test d = 0 first.
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    Real enters = interval.min;
    Real leaves = interval.max;
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = ray.origin[axis];
        const Real d = ray.direction[axis];
        Real t_min = (box.min[axis] - o) / d;
        Real t_max = (box.max[axis] - o) / d;
        enters = std::max(std::min(t_min, t_max), enters);
        leaves = std::min(std::max(t_min, t_max), leaves);
    }
    if (!(enters <= leaves)) return std::nullopt;
    return Interval{.min = enters, .max = leaves};
}

}  // namespace rt
