// origin: invented: the direction normalized
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: You normalize the direction. t = 1 is the point on the far plane.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Ray ray = correct_unprojected_ray(pixel, camera_to_world, image_to_world);
    const Vec3 d = ray.direction;
    return {.origin = ray.origin, .direction = d / std::sqrt(dot(d, d))};
}

}  // namespace rt
