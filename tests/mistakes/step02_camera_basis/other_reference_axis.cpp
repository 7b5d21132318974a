// origin: invented: (0, 0, 1) ∧ Z
// caught by: the default camera has the world's axes (MRT §2)
// sentence: You take another vector than (0, 1, 0) for v: the camera rolls to the side.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = unit(towards);
    const bool along = z.x == 0 && z.y == 0;
    const Vec3 x = along ? Vec3(0, 1, 0) : unit(cross(Vec3(0, 0, 1), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
