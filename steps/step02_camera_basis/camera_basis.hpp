// Stage 2: the camera in any direction (MRT §2; M1's view matrix).
//
//   MRT      here
//   o_C, c   the camera's position and direction
//   X, Y, Z  basis.x, basis.y, basis.z; the camera faces −Z
//   V        view_matrix(basis, position), of M1
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/basis.hpp"

namespace rt {

/// The right-handed orthonormal basis whose z points along `z` (any non-zero length) and whose x is
/// horizontal: x is along (0, 1, 0) × z, or (1, 0, 0) if z is exactly vertical. The error of each
/// component is at most 10 u, however close z is to the vertical, and however long or short: `unit`
/// in vector.hpp keeps this, GLM's normalize does not, because it squares the length.
[[nodiscard]] Basis orthonormal_basis(Vec3 z);

/// The basis of a camera that faces `direction` (any non-zero length): its z points backward.
[[nodiscard]] Basis camera_basis(Vec3 direction);

/// A ray of camera space, transformed to world space. Each of its points keeps its t.
[[nodiscard]] Ray to_world(const Ray& ray, const Basis& basis, Vec3 position);

/// M1's V: the matrix that transforms points of world space to camera space.
[[nodiscard]] Mat4 view_matrix(const Basis& basis, Vec3 position);

}  // namespace rt
