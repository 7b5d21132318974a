// right: turned by two angles, as a camera on a tripod is
#define orthonormal_basis(...) correct_basis_around(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef orthonormal_basis

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
