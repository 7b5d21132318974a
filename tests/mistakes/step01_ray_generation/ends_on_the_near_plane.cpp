// origin: M1: z = 0 for z = 1
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: Your ray ends on the near plane, z = 0 in M1's image. The far one is at z = 1.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Real x = Real(pixel.column) + Real(0.5);
    const Real y = Real(pixel.row) + Real(0.5);
    const Vec3 origin = divided_by_w(camera_to_world * Vec4(0, 0, 0, 1));
    const Vec3 end = divided_by_w(image_to_world * Vec4(x, y, 0, 1));
    return {.origin = origin, .direction = end - origin};
}

}  // namespace rt
