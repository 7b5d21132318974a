// origin: invented: a limit against a tangent that is infinite
// caught by: pixels are equal squares around the middle, in any picture (MRT §1)
// sentence: Your tangent has a largest value. A field of view may have up to 180°, and its tangent any size.
#include <algorithm>
#include <cmath>
#include "common/math/vector.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"
namespace rt {
Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real h = std::min(std::tan(vertical_fov / 2), Real(5));
    const Real w = h * Real(resolution.width) / Real(resolution.height);
    const Real u = (Real(pixel.column) + Real(0.5)) / Real(resolution.width);
    const Real v = (Real(pixel.row) + Real(0.5)) / Real(resolution.height);
    return {w * (2 * u - 1), h * (1 - 2 * v)};
}
Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec2 s = pixel_on_screen(pixel, resolution, vertical_fov);
    return {Vec3(0), Vec3(s.x, s.y, -1)};
}
Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Vec4 o = camera_to_world * Vec4(0, 0, 0, 1);
    const Vec4 p =
        image_to_world * Vec4(Real(pixel.column) + Real(0.5), Real(pixel.row) + Real(0.5), 1, 1);
    const Vec3 from = Vec3(o) / o.w;
    const Vec3 to = Vec3(p) / p.w;
    return {from, to - from};
}
}  // namespace rt
