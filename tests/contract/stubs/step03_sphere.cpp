#include "tests/contract/stub.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    return contract::ask<3, "intersect">(ray, sphere, interval);
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return contract::ask<3, "normal">(sphere, point);
}

Color color_from_normal(Vec3 normal) {
    return contract::ask<3, "color_from_normal">(normal);
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    return contract::ask<3, "torch">(point, normal, eye);
}

}  // namespace rt
