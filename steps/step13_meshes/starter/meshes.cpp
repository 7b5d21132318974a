// Stage 13, to be written: docs/step13_meshes.md says how, the header what is promised.
// Each function stands by itself. overlap and the first intersect draw boxes; into_frame and
// interpolated_normal draw meshes, and the second intersect those of fewer than 16 triangles.
// `./course check 13` says what is wrong, `./course hint 13` what to think of next.
#include "steps/step13_meshes/meshes.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"

#include <cmath>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

std::optional<Interval> overlap(const Ray& ray, const Box& box, Interval interval) {
    // From max t_min to min t_max, both of them inside the interval, or nothing.
    RT_TODO(ray, box, interval);
    return std::nullopt;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    // The smallest t strictly inside the interval at which the ray meets a face, or nothing.
    RT_TODO(ray, box, interval);
    return std::nullopt;
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    // The unit normal of the face that the point is on.
    RT_TODO(box, point);
    return Vec3(0);
}

Ray into_frame(const Ray& ray, const Motion& placement) {
    // Back by the translation, turned back, made smaller by the scale.
    RT_TODO(ray, placement);
    return ray;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    // The nearest of all the triangles, with the weights of its vertices, or nothing.
    RT_TODO(ray, mesh, interval);
    return std::nullopt;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    // Between the three, by the weights, and of unit length.
    RT_TODO(normals, weights);
    return Vec3(0);
}

}  // namespace rt
