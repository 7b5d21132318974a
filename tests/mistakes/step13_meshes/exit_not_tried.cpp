// origin: seen in student repositories: the near root only
// caught by: from inside, an oriented box is met where the ray leaves it (M1)
// sentence: From inside, t_min is behind the ray, and t_max is where it leaves the box: try that too.
#include "tests/mistakes/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    const Ray in_box{.origin = in_frame(box.basis, ray.origin - box.center),
                     .direction = in_frame(box.basis, ray.direction)};
    const auto inside = overlap(in_box, {.min = -box.half_size, .max = box.half_size},
                                {.min = -infinity, .max = infinity});
    if (!inside || !interval.contains(inside->min)) return std::nullopt;
    return inside->min;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return correct_intersect(ray, mesh, interval);
}

}  // namespace rt
