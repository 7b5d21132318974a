// origin: thought of: the minus of -Z twice
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You count z along −Z. Z points back already, and a ray that goes ahead has z = −1.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    return correct_to_world(ray, {.x = basis.x, .y = basis.y, .z = -basis.z}, position);
}

}  // namespace rt
