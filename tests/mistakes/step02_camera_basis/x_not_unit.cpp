// origin: MRT §2, erratum 3
// caught by: X is made unit length when the camera is pitched (erratum 3, MRT §2)
// sentence: Your X is (0, 1, 0) ∧ Z as printed. Its length is the sine of the angle between them: make it 1.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = unit(towards);
    const bool vertical = z.x == 0 && z.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : cross(Vec3(0, 1, 0), z);
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
