// origin: invented: a matrix of zeros, filled three rows down
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: You leave the last row 0, 0, 0, 0: every point's w becomes 0. The row is 0, 0, 0, 1.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    Mat4 view = correct_view_matrix(basis, position);
    view[3][3] = 0;
    return view;
}

}  // namespace rt
