// origin: invented: the direction normalized
// caught by: the camera's ray starts at 0 and ends on the screen at z = -1 (MRT §1)
// sentence: You normalize the direction. It ends on the plane z = −1, so that t is the depth.
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef camera_ray

namespace rt {

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec3 d(pixel_on_screen(pixel, resolution, vertical_fov), -1);
    return {.origin = Vec3(0), .direction = d / std::sqrt(dot(d, d))};
}

}  // namespace rt
