// origin: M1: the matrix for its inverse
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: You give the matrix that carries the camera into the world. V is its inverse.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    return {Vec4(basis.x, 0), Vec4(basis.y, 0), Vec4(basis.z, 0), Vec4(position, 1)};
}

}  // namespace rt
