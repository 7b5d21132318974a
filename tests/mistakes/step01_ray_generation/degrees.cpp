// origin: invented: the angle taken for degrees
// caught by: the field of view is vertical, and halved in the tangent (MRT §1)
// sentence: You convert the field of view from degrees. It is in radians already.
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return correct_pixel_on_screen(pixel, resolution, vertical_fov * pi / 180);
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
