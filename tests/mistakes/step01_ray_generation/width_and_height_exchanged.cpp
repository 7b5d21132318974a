// origin: invented: j / H, i / W
// caught by: the ratio W / H stretches x (MRT §1)
// sentence: You divide the column by H and the row by W. Columns count to W, rows to H.
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real w = Real(resolution.width);
    const Real h = Real(resolution.height);
    const Real x = 2 * (Real(pixel.column) + Real(0.5)) / h - 1;
    const Real y = 1 - 2 * (Real(pixel.row) + Real(0.5)) / w;
    const Real tangent = std::tan(vertical_fov / 2);
    return {x * w / h * tangent, y * tangent};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
