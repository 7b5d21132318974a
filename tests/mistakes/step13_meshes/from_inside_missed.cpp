// origin: invented: max t_min > 0 tested
// caught by: from inside, a ray is in the box from its start to the first t_max (M1)
// sentence: You test max t_min > 0: from inside, the ray entered before its start. min t_max must be positive.
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    Real enters = -infinity;
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
    if (!(enters <= leaves && enters > 0)) return std::nullopt;
    return Interval{.min = enters, .max = leaves};
}

}  // namespace rt
