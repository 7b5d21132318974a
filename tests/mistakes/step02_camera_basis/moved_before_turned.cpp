// origin: invented: the origin moved first, and turned with the position
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You add the position and turn the sum: the camera's place turns around the world's origin. Turn first, then move.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const Ray transformed{.origin = ray.origin + position, .direction = ray.direction};
    return correct_to_world(transformed, basis, Vec3(0));
}

}  // namespace rt
