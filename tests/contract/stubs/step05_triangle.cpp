#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    return contract::ask_hit<5>(ray, triangle, interval);
}

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<5, "barycentric">(triangle, point);
    return contract::ask<5, "barycentric">(transformed(triangle, change->any),
                                           transformed(point, change->any));
}

Vec3 normal(const Triangle& triangle, Vec3 point) {
    return contract::ask_normal<5>(triangle, point);
}

}  // namespace rt
