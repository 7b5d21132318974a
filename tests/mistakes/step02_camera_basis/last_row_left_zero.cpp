// origin: thought of: the 1 in the corner forgotten
// caught by: the view matrix takes the camera to 0, and what is ahead along -z (M1)
// sentence: The last row of your matrix is not (0, 0, 0, 1): w must stay 1.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    Mat4 view = correct_view_matrix(basis, position);
    view[3].w = 0;
    return view;
}

}  // namespace rt
