// origin: invented: v / √⟨v, v⟩ of a very short or very long v
// caught by: the direction has any length but zero (MRT §2)
// sentence: You square the direction's components: a very short one's squares are 0, a very long one's ∞. Take unit(v), or divide by the largest component first.
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#define camera_basis(...) correct_camera_basis(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis
#undef camera_basis

namespace rt {

namespace {

Vec3 by_squares(Vec3 v) {
    return v / std::sqrt(dot(v, v));
}

}  // namespace

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = by_squares(towards);
    const bool vertical = z.x == 0 && z.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : by_squares(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

}  // namespace rt
