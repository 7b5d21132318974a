// origin: M1 as printed, erratum 8
// caught by: a box behind the eye is missed (erratum 8, M1)
// sentence: You test whether the intervals of the three slabs overlap, as M1 prints it: if they do so at t < 0, the box is behind. Test min t_max > 0 too.
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    Real enters = -infinity;
    Real leaves = infinity;
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
    if (!(enters <= leaves)) return std::nullopt;
    return Interval{.min = std::max(enters, interval.min), .max = leaves};
}

}  // namespace rt
