// origin: invented: the position added to the direction
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You add the position to the direction. Only points move; directions turn.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Ray world = correct_to_world(ray, basis, position);
    return {.origin = world.origin, .direction = world.direction + position};
}

}  // namespace rt
