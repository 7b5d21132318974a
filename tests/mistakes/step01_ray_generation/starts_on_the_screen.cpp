// origin: invented: the point on the screen for the eye
// caught by: the camera's ray starts at 0 and ends on the screen at z = -1 (MRT §1)
// sentence: Your ray starts on the screen. It starts at the eye, and only passes there.
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef camera_ray

namespace rt {

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec3 screen(pixel_on_screen(pixel, resolution, vertical_fov), -1);
    return {.origin = screen, .direction = screen};
}

}  // namespace rt
