#include "steps/step04_plane/plane.hpp"

#include "common/compensated.hpp"
#include "common/vector.hpp"

namespace rt {

namespace {

/// Whether a sum of the three has one term at most, as where the plane lies across an axis: then
/// there is nothing to cancel, and the plain sum is as good as the compensated one.
bool one_term(Vec3 products) {
    return (products.x == 0) + (products.y == 0) + (products.z == 0) >= 2;
}

Real careful_dot(Vec3 a, Vec3 b) {
    const Vec3 products = a * b;
    return one_term(products) ? products.x + products.y + products.z : compensated_dot(a, b);
}

/// ⟨n, a − b⟩.
Real careful_dot(Vec3 n, Vec3 a, Vec3 b) {
    const Vec3 products = n * (a - b);
    return one_term(products) ? products.x + products.y + products.z : compensated_dot(n, a, b);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // t = ⟨o − o_r, n⟩ / ⟨d, n⟩ (MRT §4). At a grazing ray both products cancel, so both are
    // compensated: t is within 4 ulp at any angle, and no epsilon decides what is parallel.
    const Real distance = careful_dot(plane.normal, plane.point, ray.origin);
    const Real approach = careful_dot(plane.normal, ray.direction);
    const Real t = distance / approach;
    if (!interval.contains(t)) return std::nullopt;  // a parallel ray has t = ±∞ or NaN
    return t;
}

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    return unit(plane.normal);
}

}  // namespace rt
