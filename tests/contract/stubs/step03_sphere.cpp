#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    return contract::ask_hit<3>(ray, sphere, interval);
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return contract::ask_normal<3>(sphere, point);
}

Color color_from_normal(Vec3 normal) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<3, "color_from_normal">(normal);
    // The size of each coordinate, of a normal of any length.
    const Vec3 other = contract::exchanged(change->length * normal, *change);
    return contract::exchanged_back(contract::ask<3, "color_from_normal">(other), *change);
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<3, "torch">(point, normal, eye);
    return contract::ask<3, "torch">(transformed(point, change->any),
                                     change->length * rotated(normal, change->any),
                                     transformed(eye, change->any));
}

}  // namespace rt
