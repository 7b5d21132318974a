// origin: invented: the pixel's corner
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: You unproject the pixel's corner. Its center is at + 0.5.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Vec4 start = camera_to_world * Vec4(0, 0, 0, 1);
    const Vec4 end = image_to_world * Vec4(pixel.column, pixel.row, 1, 1);
    return {.origin = Vec3(start) / start.w,
            .direction = Vec3(end) / end.w - Vec3(start) / start.w};
}

}  // namespace rt
