// origin: thought of: glm::normalize
// caught by: the direction has any length but zero (contract)
// sentence: You divide by the root of a sum of squares, which is 0 for a short direction and infinite for a long one. unit() of common/vector.hpp divides by the largest component first.
#define basis_around(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef basis_around
#undef camera_basis

namespace rt {

Basis basis_around(Vec3 towards) {
    const Vec3 z = normalize(towards);
    const bool vertical = towards.x == 0 && towards.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return basis_around(-direction);
}

}  // namespace rt
