#include "steps/step01_ray_generation/ray_generation.hpp"

#include <cmath>
#include <limits>

namespace rt {

namespace {

Vec3 divided_by_w(Vec4 point) {
    return Vec3(point) / point.w;
}

/// The tangent, cached for the next pixel: all pixels of a picture use the same one, and it would
/// take a sixth of the time of a simple picture.
Real tangent(Real angle) {
    // Not zero-initialized: mold 1.10 would then link programs that may not start.
    struct Last {
        Real angle = std::numeric_limits<Real>::quiet_NaN();
        Real tangent = 0;
    };
    thread_local Last last;
    if (angle != last.angle) last = {.angle = angle, .tangent = std::tan(angle)};
    return last.tangent;
}

}  // namespace

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    // 2 · (j + 0.5) / W − 1 with the subtraction in integers, where it is exact.
    const Real x = Real(2 * pixel.column + 1 - resolution.width);
    const Real y = Real(resolution.height - 2 * pixel.row - 1);
    const Real half_pixel = tangent(vertical_fov / 2) / Real(resolution.height);
    return {x * half_pixel, y * half_pixel};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec2 screen = pixel_on_screen(pixel, resolution, vertical_fov);
    return {.origin = Vec3(0), .direction = Vec3(screen, -1)};
}

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Real x = Real(pixel.column) + Real(0.5);
    const Real y = Real(pixel.row) + Real(0.5);
    const Vec3 origin = divided_by_w(camera_to_world * Vec4(0, 0, 0, 1));
    const Vec3 end = divided_by_w(image_to_world * Vec4(x, y, 1, 1));
    return {.origin = origin, .direction = end - origin};
}

}  // namespace rt
