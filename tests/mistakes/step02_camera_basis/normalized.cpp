// origin: invented: the direction made unit
// caught by: t keeps its meaning: a turned direction keeps its length (MRT §2)
// sentence: You normalize the direction: t no longer means what it meant in the camera's frame.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Ray world = correct_to_world(ray, basis, position);
    return {.origin = world.origin, .direction = unit(world.direction)};
}

}  // namespace rt
