#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const Box& box, Interval interval) {
    return contract::ask<13, "overlap">(ray, box, interval);
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return contract::ask<13, "intersect">(ray, box, interval);
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    return contract::ask<13, "normal">(box, point);
}

Ray into_frame(const Ray& ray, const Motion& placement) {
    return contract::ask<13, "into_frame">(ray, placement);
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return contract::ask<13, "intersect">(ray, mesh, interval);
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    return contract::ask<13, "interpolated_normal">(normals, weights);
}

}  // namespace rt
