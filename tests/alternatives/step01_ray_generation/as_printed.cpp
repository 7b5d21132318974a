// right: MRT §1 as printed
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec2 norm((Real(pixel.column) + Real(0.5)) / Real(resolution.width),
                    (Real(pixel.row) + Real(0.5)) / Real(resolution.height));
    const Vec2 screen(2 * norm.x - 1, 1 - 2 * norm.y);
    const Real ratio = Real(resolution.width) / Real(resolution.height);
    return {screen.x * ratio * std::tan(vertical_fov / 2), screen.y * std::tan(vertical_fov / 2)};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
