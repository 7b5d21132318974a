// origin: M1 by its second paper: "d < 0" tested in place of the sign of 1 / d
// caught by: a coordinate of the direction may be 0, and -0 is 0 (M1, Williams et al.)
// sentence: You test d < 0, and -0 is not less than 0: its t_min and t_max are exchanged, and the ray misses. Test d = 0 first, or the sign of 1 / d.
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    if (std::isnan(dot(ray.origin, ray.direction))) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        const bool backwards = ray.direction[axis] < 0;
        const Real t_min =
            ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) / ray.direction[axis];
        const Real t_max =
            ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) / ray.direction[axis];
        if (t_min > interval.min) interval.min = t_min;
        if (t_max < interval.max) interval.max = t_max;
    }
    if (interval.min > interval.max) return std::nullopt;
    return interval;
}

}  // namespace rt
