// origin: invented: ⟨X, o_C⟩ for −⟨X, o_C⟩
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: Your view matrix moves the camera twice as far away. The last column is −⟨X, o_C⟩, −⟨Y, o_C⟩, −⟨Z, o_C⟩.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    return correct_view_matrix(basis, -position);
}

}  // namespace rt
