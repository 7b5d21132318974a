// origin: seen in student repositories
// caught by: Z is against the direction, X to the right, Y upwards (MRT §2)
// sentence: Your X is Z ∧ (0, 1, 0): the picture is mirrored. It is (0, 1, 0) ∧ Z.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = unit(towards);
    const bool vertical = z.x == 0 && z.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(z, Vec3(0, 1, 0)));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
