// origin: M1: the division forgotten
// caught by: both ends are divided by their w (M1)
// sentence: You leave the division by w out for the ray's start.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Ray ray = correct_unprojected_ray(pixel, camera_to_world, image_to_world);
    const Vec3 end = ray.origin + ray.direction;
    const Vec3 origin(camera_to_world * Vec4(0, 0, 0, 1));
    return {.origin = origin, .direction = end - origin};
}

}  // namespace rt
