// origin: seen in student repositories
// caught by: the row goes down, the column to the right (MRT §1, i and j)
// sentence: You exchange i and j: i is the row, and gives y; j is the column, and gives x.
#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#define camera_ray(...) correct_camera_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen
#undef camera_ray

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return correct_pixel_on_screen({.row = pixel.column, .column = pixel.row}, resolution,
                                   vertical_fov);
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
