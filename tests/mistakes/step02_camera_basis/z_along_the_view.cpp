// origin: seen in student repositories
// caught by: Z is against the direction, X to the right, Y upwards (MRT §2)
// sentence: Your Z points where the camera looks. MRT §2 has Z = −c: the camera looks along −Z.
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef camera_basis

namespace rt {

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(direction);
}

}  // namespace rt
