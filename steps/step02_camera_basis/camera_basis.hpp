// Stage 2: the camera looks anywhere (MRT §2; M1's view matrix).
//
//   MRT      here
//   o_C, c   the camera's position and direction
//   X, Y, Z  basis.x, basis.y, basis.z; the camera looks along −Z
//   V        view_matrix(basis, position), of M1
#pragma once

#include "common/basis.hpp"
#include "common/ray.hpp"

namespace rt {

/// The right-handed orthonormal basis whose z points along `z` (any non-zero length) and whose x
/// is horizontal: x is along (0, 1, 0) × z, or (1, 0, 0) if z is exactly vertical. Each component
/// is within 10 u, however near the vertical z is.
[[nodiscard]] Basis basis_around(Vec3 z);

/// The basis of a camera that looks along `direction` (any non-zero length): its z points back.
[[nodiscard]] Basis camera_basis(Vec3 direction);

/// The ray, given in the camera's frame, carried into the world. t keeps its meaning.
[[nodiscard]] Ray to_world(const Ray& ray, const Basis& basis, Vec3 position);

/// M1's V: takes a point of the world to the camera's frame.
[[nodiscard]] Mat4 view_matrix(const Basis& basis, Vec3 position);

}  // namespace rt
