#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const BoundingBox& box, Interval interval) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "overlap">(ray, box, interval);
    const Transform& transform = change->boxes;
    const std::optional<Interval> got = contract::ask<13, "overlap">(
        contract::transformed(ray, transform, change->length),
        contract::transformed(box, transform), contract::divided(interval, change->length));
    return got ? contract::divided(*got, 1 / change->length) : got;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return contract::ask_hit<13>(ray, box, interval);
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    return contract::ask_normal<13>(box, point);
}

// Mesh and ray move together: in the mesh's frame nothing changes.
Ray to_object_space(const Ray& ray, const Transform& placement) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "to_object_space">(ray, placement);
    Ray got = contract::ask<13, "to_object_space">(
        contract::transformed(ray, change->any, change->length),
        contract::transformed(placement, change->any));
    got.direction /= change->length;
    return got;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "intersect">(ray, mesh, interval);
    std::optional<MeshHit> got = contract::ask<13, "intersect">(
        contract::transformed(ray, change->any, change->length),
        contract::transformed(mesh, change->any), contract::divided(interval, change->length));
    if (got) got->t *= change->length;
    return got;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "interpolated_normal">(normals, weights);
    const Transform& transform = change->any;
    const auto& [a, b, c] = normals;
    return contract::turned_back(
        contract::ask<13, "interpolated_normal">(
            std::array<Vec3, 3>{rotated(a, transform), rotated(b, transform),
                                rotated(c, transform)},
            weights),
        transform);
}

}  // namespace rt
