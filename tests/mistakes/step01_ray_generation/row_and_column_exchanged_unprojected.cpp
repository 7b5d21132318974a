// origin: invented: x the row, y the column
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: You take the row for x and the column for y. x counts columns, y counts rows.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    return correct_unprojected_ray({.row = pixel.column, .column = pixel.row}, camera_to_world,
                                   image_to_world);
}

}  // namespace rt
