// origin: invented: its basis never looked at
// caught by: an oriented box turns with its basis (M1)
// sentence: You take every box for one along the axes of the scene. Take the coordinates of o − c and of d along u, v and w.
#include "tests/mistakes/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    OrientedBox upright = box;
    upright.basis = Basis{};
    return correct_intersect(ray, upright, interval);
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return correct_intersect(ray, mesh, interval);
}

}  // namespace rt
