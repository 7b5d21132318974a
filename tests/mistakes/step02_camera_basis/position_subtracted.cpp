// origin: invented: the view matrix's sign
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You subtract the position. That leads into the camera's frame; out of it the position is added.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    return correct_to_world(ray, basis, -position);
}

}  // namespace rt
