// origin: M1 as printed
// caught by: a flat box is hit: max t_min = min t_max is no miss (M1)
// sentence: You test max t_min < min t_max: a box without thickness is never hit. The test is ≤.
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
        if (d == 0) {
            if (!(box.min[axis] <= o && o <= box.max[axis])) return std::nullopt;
            continue;
        }
        Real t_min = (box.min[axis] - o) / d;
        Real t_max = (box.max[axis] - o) / d;
        if (t_min > t_max) std::swap(t_min, t_max);
        enters = std::max(enters, t_min);
        leaves = std::min(leaves, t_max);
    }
    if (!(enters < leaves)) return std::nullopt;
    return Interval{.min = enters, .max = leaves};
}

}  // namespace rt
