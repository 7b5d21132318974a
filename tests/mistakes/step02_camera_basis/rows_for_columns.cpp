// origin: GLM: m[0] is a column
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: You fill GLM's matrix row by row. m[0] is its first column.
#include <glm/matrix.hpp>

#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    return glm::transpose(correct_view_matrix(basis, position));
}

}  // namespace rt
