// origin: invented: t_min taken on box.min whatever the sign of d
// caught by: a ray is in the box from the last t_min to the first t_max (M1)
// sentence: You take t_min on pmin always. If d is negative, the ray reaches pmax first: exchange them.
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
        enters = std::max(enters, t_min);
        leaves = std::min(leaves, t_max);
    }
    if (!(enters <= leaves)) return std::nullopt;
    return Interval{.min = enters, .max = leaves};
}

}  // namespace rt
