// origin: invented: the turn alone
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: Your view matrix only rotates. It must move the camera's position to 0.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

namespace {

Mat4 view_matrix_of_turn(const Basis& basis) {
    return correct_view_matrix(basis, Vec3(0));
}

}  // namespace

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    return view_matrix_of_turn(basis);
}

}  // namespace rt
