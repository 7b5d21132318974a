// Stage 2, to be written: docs/step02_camera_basis.md says how, the header what is promised.
// Begin with basis_around: camera_basis needs it. The other two are given a basis.
// `./course check 2` says what is wrong, `./course hint 2` what to think of next.
#include "steps/step02_camera_basis/camera_basis.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

Basis basis_around(Vec3 z) {
    // X = (0, 1, 0) ∧ Z made unit length, or (1, 0, 0) if Z is vertical. Y = Z ∧ X.
    RT_TODO(z);
    return {};
}

Basis camera_basis(Vec3 direction) {
    // The basis whose z points back.
    RT_TODO(direction);
    return {};
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    // The ray of the camera's frame, in the world.
    RT_TODO(basis, position);
    return ray;
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    // M1's V. GLM's matrices are lists of columns.
    RT_TODO(basis, position);
    return Mat4(0);
}

}  // namespace rt
