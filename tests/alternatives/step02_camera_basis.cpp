// right as_printed around orthonormal_basis camera_basis view_matrix: MRT §2 with X normalized; V
// as in M1, a translation and then a rotation
namespace rt {

Basis orthonormal_basis(Vec3 towards) {
    const Vec3 z = unit(towards);
    Vec3 x(1, 0, 0);
    if (z.x != 0 || z.z != 0) x = unit(cross(Vec3(0, 1, 0), z));
    return {.x = x, .y = cross(z, x), .z = z};
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const auto& [x, y, z] = basis;
    const Mat4 turn(Vec4(x.x, y.x, z.x, 0), Vec4(x.y, y.y, z.y, 0), Vec4(x.z, y.z, z.z, 0),
                    Vec4(0, 0, 0, 1));
    Mat4 move(1);
    move[3] = Vec4(-position, 1);
    return turn * move;
}

}  // namespace rt

// right by_angles around orthonormal_basis: turned by two angles, as a camera on a tripod is
namespace rt {

Basis orthonormal_basis(Vec3 z) {
    const Real yaw = std::atan2(z.x, z.z);
    const Real pitch = std::atan2(z.y, std::hypot(z.x, z.z));
    const Vec3 forward(std::sin(yaw), 0, std::cos(yaw));  // level, above or below z
    const Vec3 up(0, 1, 0);
    return {.x = {std::cos(yaw), 0, -std::sin(yaw)},
            .y = std::cos(pitch) * up - std::sin(pitch) * forward,
            .z = std::sin(pitch) * up + std::cos(pitch) * forward};
}

}  // namespace rt

// right by_inverse around view_matrix: the inverse of the matrix that carries the camera into the
// world
#include <glm/matrix.hpp>

namespace rt {

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const Mat4 camera_to_world(Vec4(basis.x, 0), Vec4(basis.y, 0), Vec4(basis.z, 0),
                               Vec4(position, 1));
    return glm::inverse(camera_to_world);
}

}  // namespace rt
