// right: MRT §2 as it stands, with X made unit length, and GLM's own matrices
#include "common/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace rt {

Basis basis_around(Vec3 towards) {
    const Vec3 z = unit(towards);
    const bool vertical = towards.x == 0 && towards.z == 0;
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return basis_around(-direction);
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const glm::mat<3, 3, Real> turn(basis.x, basis.y, basis.z);
    return {.origin = turn * ray.origin + position, .direction = turn * ray.direction};
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const glm::mat<3, 3, Real> turn(basis.x, basis.y, basis.z);
    return glm::translate(Mat4(glm::transpose(turn)), -position);
}

}  // namespace rt
