// origin: seen in student repositories: c == (0, ±1, 0)
// caught by: a vertical view takes X = (1, 0, 0) (MRT §2)
// sentence: You test whether the direction is (0, ±1, 0) before you normalize it: (0, −0.125, 0) points down as well.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = unit(towards);
    const bool vertical = towards == Vec3(0, 1, 0) || towards == Vec3(0, -1, 0);
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
