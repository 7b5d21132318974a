// origin: invented: ⟨v, X⟩ for v.x X + v.y Y + v.z Z
// caught by: a ray of the camera's frame is carried into the world (MRT §2)
// sentence: You take ⟨v, X⟩, ⟨v, Y⟩, ⟨v, Z⟩: that leads from the world into the camera's frame, not out of it.
#define to_world(...) correct_to_world(__VA_ARGS__)
#include "steps/step02_camera_basis/reference/camera_basis.cpp"
#undef to_world

namespace rt {

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const auto rotated = [&](Vec3 v) {
        return Vec3(dot(v, basis.x), dot(v, basis.y), dot(v, basis.z));
    };
    return {.origin = position + rotated(ray.origin), .direction = rotated(ray.direction)};
}

}  // namespace rt
