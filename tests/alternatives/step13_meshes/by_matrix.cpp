// right: HAI's matrices: the placement as one matrix, the ray by its inverse
#define to_object_space(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef to_object_space
#include <glm/matrix.hpp>

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const auto& [x, y, z] = placement.rotation;
    Mat4 matrix(1);
    matrix[0] = Vec4(placement.scale * x, 0);
    matrix[1] = Vec4(placement.scale * y, 0);
    matrix[2] = Vec4(placement.scale * z, 0);
    matrix[3] = Vec4(placement.translation, 1);
    const Mat4 inverse = glm::inverse(matrix);
    return {.origin = Vec3(inverse * Vec4(ray.origin, 1)),
            .direction = Vec3(inverse * Vec4(ray.direction, 0))};
}

}  // namespace rt
