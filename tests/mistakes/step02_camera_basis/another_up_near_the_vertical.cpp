// origin: seen elsewhere: v = (0, 0, 1) for steep views
// caught by: however near the vertical, X is where the formula has it (MRT §2, contract)
// sentence: For steep views you exchange (0, 1, 0) for another vector: the camera rolls as it comes near. Only a view that is exactly vertical needs a rule.
#define basis_around(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef basis_around
#undef camera_basis

namespace rt {

Basis basis_around(Vec3 towards) {
    const Vec3 z = unit(towards);
    const Vec3 v = std::abs(z.y) > Real(0.99) ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const Vec3 x = unit(cross(v, z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return basis_around(-direction);
}

}  // namespace rt
