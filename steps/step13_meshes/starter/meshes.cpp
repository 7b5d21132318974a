// Stage 13, to be written. docs/step13_meshes.md explains it, the header is its contract.
// Write them in this order. overlap, the first intersect and normal are for boxes; to_object_space
// and interpolated_normal are for meshes, and the second intersect for those of fewer than 16
// triangles.
// `./course check 13` reports errors, `./course hint 13` prints the next hint.
#include "steps/step13_meshes/meshes.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include "steps/step05_triangle/triangle.hpp"

#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    // From max t_min to min t_max, both of them inside the interval, or nothing.
    RT_TODO(ray, box, interval);
    return std::nullopt;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    // The smallest t strictly inside the interval at which the ray hits a face, or nothing.
    RT_TODO(ray, box, interval);
    return std::nullopt;
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    // The unit normal of the face that contains the point.
    RT_TODO(box, point);
    return Vec3(0);
}

Ray to_object_space(const Ray& ray, const Transform& placement) {
    // The inverse of the placement: translate back, rotate back, divide by the scale.
    RT_TODO(ray, placement);
    return ray;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    // The closest hit among all triangles, with its barycentric coordinates, or nothing.
    RT_TODO(ray, mesh, interval);
    return std::nullopt;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    // The interpolated normal, of unit length.
    RT_TODO(normals, weights);
    return Vec3(0);
}

}  // namespace rt
