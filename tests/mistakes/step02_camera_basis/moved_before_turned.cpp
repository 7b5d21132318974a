// origin: thought of: the position added, then the turn
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You add the position and then turn. The position stands in the world already: turn first, then move.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    return correct_to_world({.origin = ray.origin + position, .direction = ray.direction}, basis,
                            Vec3(0));
}

}  // namespace rt
