// right: steps of one pixel from the screen's upper left corner
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real half_height = std::tan(vertical_fov / 2);
    const Real step = 2 * half_height / Real(resolution.height);
    const Real half_width = step * Real(resolution.width) / 2;
    return {-half_width + (Real(pixel.column) + Real(0.5)) * step,
            half_height - (Real(pixel.row) + Real(0.5)) * step};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
