// right: the inverse of the matrix that carries the camera into the world
#include <glm/matrix.hpp>

#define view_matrix(...) correct_view_matrix(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef view_matrix

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const Mat4 camera_to_world(Vec4(basis.x, 0), Vec4(basis.y, 0), Vec4(basis.z, 0),
                               Vec4(position, 1));
    return glm::inverse(camera_to_world);
}

}  // namespace rt
