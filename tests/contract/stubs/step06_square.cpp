#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    return contract::ask_hit<6>(ray, square, interval);
}

Vec2 square_uv(const Square& square, Vec3 point) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<6, "square_uv">(square, point);
    return contract::ask<6, "square_uv">(transformed(square, change->any),
                                         transformed(point, change->any));
}

Vec3 normal(const Square& square, Vec3 point) {
    return contract::ask_normal<6>(square, point);
}

}  // namespace rt
