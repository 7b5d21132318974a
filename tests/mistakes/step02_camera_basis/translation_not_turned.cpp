// origin: invented: −position in the last column
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: You put −o_C into the last column. The rotation follows the translation: it is −⟨X, o_C⟩, −⟨Y, o_C⟩, −⟨Z, o_C⟩.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    Mat4 view = correct_view_matrix(basis, position);
    view[3] = Vec4(-position, 1);
    return view;
}

}  // namespace rt
