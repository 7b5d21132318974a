// origin: seen in student repositories
// caught by: rays go through the centers of pixels: + 0.5, over W and H (MRT §1)
// sentence: You leave + 0.5 out: your rays go through the pixels' corners.
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real w = Real(resolution.width);
    const Real h = Real(resolution.height);
    const Real x = 2 * (Real(pixel.column)) / w - 1;
    const Real y = 1 - 2 * (Real(pixel.row)) / h;
    const Real tangent = std::tan(vertical_fov / 2);
    return {x * w / h * tangent, y * tangent};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
