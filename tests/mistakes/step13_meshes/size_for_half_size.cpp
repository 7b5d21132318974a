// origin: invented: from −size / 2 to size / 2 of what is half already
// caught by: a ray meets the near face of an oriented box, half a size from its center (M1)
// sentence: You halve half_size again, or the box is half as wide as it should be: it reaches from −half_size to half_size.
#include "tests/mistakes/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    OrientedBox half = box;
    half.half_size = box.half_size / Real(2);
    return correct_intersect(ray, half, interval);
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return correct_intersect(ray, mesh, interval);
}

}  // namespace rt
