// origin: invented: the origin turned and moved, the direction left as it was
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You do not rotate the direction: the camera looks along −z, whatever its basis.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Ray world = correct_to_world(ray, basis, position);
    return {.origin = world.origin, .direction = ray.direction};
}

}  // namespace rt
