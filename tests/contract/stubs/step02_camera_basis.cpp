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
Vec3 turned(Vec3 direction, const Change& change) {
    constexpr Real most = std::numeric_limits<Real>::max() / 64;
    constexpr Real least = std::numeric_limits<Real>::min() / unit_roundoff;
    const Real size = largest_component(direction);
    if (!(least < size && size < most)) return direction;
    const Vec3 longer = change.length * direction;
    return is_vertical(direction) ? longer : contract::turned_direction(longer, change.upright);
}

/// The answer for the rotated direction, rotated back.
Basis turned_back(const Basis& came, Vec3 direction, const Change& change) {
    if (is_vertical(direction) || turned(direction, change) == direction) return came;
    return {.x = contract::turned_back(came.x, change.upright),
            .y = contract::turned_back(came.y, change.upright),
            .z = contract::turned_back(came.z, change.upright)};
}

}  // namespace

Basis basis_around(Vec3 z) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "basis_around">(z);
    return turned_back(contract::ask<2, "basis_around">(turned(z, *change)), z, *change);
}

Basis camera_basis(Vec3 direction) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "camera_basis">(direction);
    return turned_back(contract::ask<2, "camera_basis">(turned(direction, *change)), direction,
                       *change);
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "to_world">(ray, basis, position);
    const Motion& motion = change->any;
    const Ray grown{.origin = motion.scale * ray.origin,
                    .direction = change->length * motion.scale * ray.direction};
    return contract::moved_back(contract::ask<2, "to_world">(grown, contract::turned(basis, motion),
                                                             moved(position, motion)),
                                motion, change->length);
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<2, "view_matrix">(basis, position);
    Motion motion = change->any;
    motion.scale = 1;  // a view has the world's
    return contract::ask<2, "view_matrix">(contract::turned(basis, motion),
                                           moved(position, motion)) *
           contract::matrix_of(motion);
}

}  // namespace rt
