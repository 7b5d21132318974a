// origin: invented: the direction not normalized
// caught by: the direction has any length but zero (MRT §2)
// sentence: Your Z is as long as the direction. Make it a unit vector.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Basis basis = correct_basis_around(towards);
    return {.x = basis.x, .y = cross(towards, basis.x), .z = towards};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
