// origin: M1: the division forgotten
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: You leave the division by w out: a point behind a perspective matrix has a w that is not 1.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Ray ray = correct_unprojected_ray(pixel, camera_to_world, image_to_world);
    const Vec3 end(image_to_world *
                   Vec4(Real(pixel.column) + Real(0.5), Real(pixel.row) + Real(0.5), 1, 1));
    return {.origin = ray.origin, .direction = end - ray.origin};
}

}  // namespace rt
