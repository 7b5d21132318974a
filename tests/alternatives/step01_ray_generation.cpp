// right as_printed around pixel_on_screen camera_ray: MRT §1 as printed
namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Vec2 norm((Real(pixel.column) + Real(0.5)) / Real(resolution.width),
                    (Real(pixel.row) + Real(0.5)) / Real(resolution.height));
    const Vec2 screen(2 * norm.x - 1, 1 - 2 * norm.y);
    const Real ratio = Real(resolution.width) / Real(resolution.height);
    return {screen.x * ratio * std::tan(vertical_fov / 2), screen.y * std::tan(vertical_fov / 2)};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt

// right counted_in_pixels: pixels counted from the middle of the screen, and M1's end as the
// difference of two points
#include <cmath>

#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real side = 2 * std::tan(vertical_fov / 2) / Real(resolution.height);
    const Vec2 corner = Real(-0.5) * side * Vec2(resolution.width, -resolution.height);
    return corner + side * Vec2(Real(pixel.column) + Real(0.5), -Real(pixel.row) - Real(0.5));
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Vec4 start = camera_to_world[3];
    const Vec4 end = image_to_world * Vec4(pixel.column, pixel.row, 1, 1) +
                     Real(0.5) * (image_to_world[0] + image_to_world[1]);
    return {.origin = Vec3(start) / start.w, .direction = Vec3(end / end.w - start / start.w)};
}

}  // namespace rt

// right from_the_corner around pixel_on_screen camera_ray: steps of one pixel from the screen's
// upper left corner
namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real half_height = std::tan(vertical_fov / 2);
    const Real step = 2 * half_height / Real(resolution.height);
    const Real half_width = step * Real(resolution.width) / 2;
    return {-half_width + (Real(pixel.column) + Real(0.5)) * step,
            half_height - (Real(pixel.row) + Real(0.5)) * step};
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return {.origin = Vec3(0),
            .direction = Vec3(pixel_on_screen(pixel, resolution, vertical_fov), -1)};
}

}  // namespace rt
