#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Interval> overlap(const Ray& ray, const Box& box, Interval interval) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "overlap">(ray, box, interval);
    const Motion& motion = change->boxes;
    const std::optional<Interval> came = contract::ask<13, "overlap">(
        contract::moved(ray, motion, change->length), contract::moved(box, motion),
        contract::divided(interval, change->length));
    return came ? contract::divided(*came, 1 / change->length) : came;
}

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return contract::ask_hit<13>(ray, box, interval);
}

Vec3 normal(const OrientedBox& box, Vec3 point) {
    return contract::ask_normal<13>(box, point);
}

// Mesh and ray move together: in the mesh's frame nothing changes.
Ray into_frame(const Ray& ray, const Motion& placement) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "into_frame">(ray, placement);
    Ray came = contract::ask<13, "into_frame">(contract::moved(ray, change->any, change->length),
                                               contract::moved(placement, change->any));
    came.direction /= change->length;
    return came;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "intersect">(ray, mesh, interval);
    std::optional<MeshHit> came = contract::ask<13, "intersect">(
        contract::moved(ray, change->any, change->length), contract::moved(mesh, change->any),
        contract::divided(interval, change->length));
    if (came) came->t *= change->length;
    return came;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<13, "interpolated_normal">(normals, weights);
    const Motion& motion = change->any;
    const auto& [a, b, c] = normals;
    return contract::turned_back(
        contract::ask<13, "interpolated_normal">(
            std::array<Vec3, 3>{turned(a, motion), turned(b, motion), turned(c, motion)}, weights),
        motion);
}

}  // namespace rt
