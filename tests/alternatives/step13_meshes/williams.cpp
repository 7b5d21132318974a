// right: the algorithm of M1's second paper, by 1 / d and its sign
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    // A comparison with NaN is false: 0 · ∞ on a face is no bound.
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isnan(ray.origin[axis]) || std::isnan(ray.direction[axis])) return std::nullopt;
        const Real inverse = 1 / ray.direction[axis];
        const bool backwards = std::signbit(inverse);
        const Real t_min = ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) * inverse;
        const Real t_max = ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) * inverse;
        if (interval.min > t_max || t_min > interval.max) return std::nullopt;
        if (t_min > interval.min) interval.min = t_min;
        if (t_max < interval.max) interval.max = t_max;
    }
    return interval;
}

}  // namespace rt
