// origin: a student's: an epsilon on the direction
// caught by: a ray that is almost parallel to a slab crosses it: there is no epsilon (contract)
// sentence: You call a ray parallel to a slab that is not: it may cross it far away. Compare d with 0.
#define overlap(...) correct_overlap(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef overlap

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    Ray changed = ray;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(ray.direction[axis]) < Real(1e-4) * length(ray.direction))
            changed.direction[axis] = 0;
    return correct_overlap(changed, box, interval);
}

}  // namespace rt
