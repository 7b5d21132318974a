// origin: M1: another two of its three points
// caught by: by inverse matrices the ray starts at the camera and ends on the far plane (M1)
// sentence: Your ray starts on the near plane: M1 allows it, the contract does not. It starts at the camera.
#define unprojected_ray(...) correct_unprojected_ray(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef unprojected_ray

namespace rt {

Ray unprojected_ray(Pixel pixel, const Mat4& /*camera_to_world*/, const Mat4& image_to_world) {
    const Real x = Real(pixel.column) + Real(0.5);
    const Real y = Real(pixel.row) + Real(0.5);
    const Vec3 start = divided_by_w(image_to_world * Vec4(x, y, 0, 1));
    const Vec3 end = divided_by_w(image_to_world * Vec4(x, y, 1, 1));
    return {.origin = start, .direction = end - start};
}

}  // namespace rt
