// origin: invented: a matrix kept for the next call
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: You keep the view matrix for the next call, and compare the position alone. Another basis at the same position has another matrix: keep nothing between calls.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    struct Kept {
        Vec3 position;
        Mat4 matrix;
    };
    static thread_local std::optional<Kept> kept;
    if (!kept || kept->position != position)
        kept = Kept{.position = position, .matrix = correct_view_matrix(basis, position)};
    return kept->matrix;
}

}  // namespace rt
