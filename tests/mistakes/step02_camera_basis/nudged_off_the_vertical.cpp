// origin: seen in student repositories
// caught by: a vertical view takes X = (1, 0, 0) (MRT §2)
// sentence: You nudge the direction off the vertical: the camera no longer looks in the given direction.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    Vec3 z = unit(towards);
    if (z.x == 0 && z.z == 0) z = unit(z + Vec3(Real(0.001), 0, 0));
    const Vec3 x = unit(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
