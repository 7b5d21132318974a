// origin: thought of: X = (-1, 0, 0) looking down
// caught by: a vertical view takes X = (1, 0, 0) (MRT §2)
// sentence: Looking down you take X = (−1, 0, 0). MRT §2 takes (1, 0, 0) up and down.
#define basis_around(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef basis_around
#undef camera_basis

namespace rt {

Basis basis_around(Vec3 towards) {
    Basis basis = correct_basis_around(towards);
    if (towards.x == 0 && towards.z == 0 && towards.y > 0) {
        basis.x = -basis.x;
        basis.y = -basis.y;
    }
    return basis;
}

Basis camera_basis(Vec3 direction) {
    return basis_around(-direction);
}

}  // namespace rt
