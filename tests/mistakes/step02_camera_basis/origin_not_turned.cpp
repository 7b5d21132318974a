// origin: invented: only the direction turned
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You add the origin without turning it. It stands in the camera's frame, like the direction.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Ray world = correct_to_world(ray, basis, position);
    return {.origin = position + ray.origin, .direction = world.direction};
}

}  // namespace rt
