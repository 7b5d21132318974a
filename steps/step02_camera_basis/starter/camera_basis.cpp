// Stage 2, to be written. docs/step02_camera_basis.md explains it, the header is its contract.
// Begin with orthonormal_basis: camera_basis needs it. The other two functions get a basis as an
// argument.
// `./course check 2` reports errors, `./course hint 2` prints the next hint.
#include "steps/step02_camera_basis/camera_basis.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

Basis orthonormal_basis(Vec3 z) {
    // X = (0, 1, 0) ∧ Z scaled to unit length, or (1, 0, 0) if Z is vertical. Y = Z ∧ X.
    RT_TODO(z);
    return {};
}

Basis camera_basis(Vec3 direction) {
    // The basis whose z points backward.
    RT_TODO(direction);
    return {};
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    // The ray of camera space, in world space.
    RT_TODO(basis, position);
    return ray;
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    // M1's V. GLM's matrices are lists of columns.
    RT_TODO(basis, position);
    return Mat4(0);
}

}  // namespace rt
