// origin: invented: the direction for Z in the third row
// caught by: the view matrix maps the camera to 0, and the view direction to -z (M1)
// sentence: Your third row is the direction: points ahead get z > 0. It is Z = −c, and points ahead have z < 0.
#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    return correct_view_matrix({.x = basis.x, .y = basis.y, .z = -basis.z}, position);
}

}  // namespace rt
