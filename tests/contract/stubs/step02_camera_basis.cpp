#include "tests/contract/stub.hpp"

namespace rt {

namespace {

using contract::Change;

/// The contract's up direction is fixed; for a direction straight up or down, X is the world's, so
/// nothing is rotated.
bool is_vertical(Vec3 direction) {
    return direction.x == 0 && direction.z == 0;
}

/// The direction after the rotation, scaled unless the result is too long or short for full
/// precision.
Vec3 rotated(Vec3 direction, const Change& change) {
    constexpr Real most = std::numeric_limits<Real>::max() / 64;
    constexpr Real least = std::numeric_limits<Real>::min() / unit_roundoff;
    const Real size = largest_component(direction);
    if (!(least < size && size < most)) return direction;
    const Vec3 longer = change.length * direction;
    return is_vertical(direction) ? longer : contract::turned_direction(longer, change.upright);
}

/// The answer for the rotated direction, rotated back.
Basis turned_back(const Basis& got, Vec3 direction, const Change& change) {
    if (is_vertical(direction) || rotated(direction, change) == direction) return got;
    return {.x = contract::turned_back(got.x, change.upright),
            .y = contract::turned_back(got.y, change.upright),
            .z = contract::turned_back(got.z, change.upright)};
}

}  // namespace

Basis orthonormal_basis(Vec3 z) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "orthonormal_basis">(z);
    return turned_back(contract::ask<2, "orthonormal_basis">(rotated(z, *change)), z, *change);
}

Basis camera_basis(Vec3 direction) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "camera_basis">(direction);
    return turned_back(contract::ask<2, "camera_basis">(rotated(direction, *change)), direction,
                       *change);
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "to_world">(ray, basis, position);
    const Transform& transform = change->any;
    const Ray grown{.origin = transform.scale * ray.origin,
                    .direction = change->length * transform.scale * ray.direction};
    return contract::moved_back(contract::ask<2, "to_world">(grown, rt::rotated(basis, transform),
                                                             transformed(position, transform)),
                                transform, change->length);
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "view_matrix">(basis, position);
    Transform transform = change->any;
    transform.scale = 1;  // a view has the world's
    return contract::ask<2, "view_matrix">(rt::rotated(basis, transform),
                                           transformed(position, transform)) *
           contract::matrix_of(transform);
}

}  // namespace rt
