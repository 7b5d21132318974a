// right: pixels counted from the middle of the screen, and M1's end as the difference of two points
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
