// origin: invented: +1 for −1
// caught by: the camera's ray starts at 0 and ends on the screen at z = -1 (MRT §1)
// sentence: Your camera looks backwards: the screen stands at z = −1.
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef camera_ray

namespace rt {

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), 1)};
}

}  // namespace rt
