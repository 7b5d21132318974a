#include "tests/contract/stub.hpp"

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return contract::ask<1, "pixel_on_screen">(pixel, resolution, vertical_fov);
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return contract::ask<1, "camera_ray">(pixel, resolution, vertical_fov);
}

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    return contract::ask<1, "unprojected_ray">(pixel, camera_to_world, image_to_world);
}

}  // namespace rt
