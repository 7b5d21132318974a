#include "tests/contract/stub.hpp"

namespace rt {

namespace {

using contract::Change;

// A picture of an odd number of pixels in place of each has the same middles; and a screen grows
// with the tangent of half the field of view.
Pixel finer(Pixel pixel, const Change& change) {
    return {.row = change.finer * pixel.row + change.finer / 2,
            .column = change.finer * pixel.column + change.finer / 2};
}

Resolution finer(Resolution resolution, const Change& change) {
    return {.width = change.finer * resolution.width, .height = change.finer * resolution.height};
}

Real zoomed(Real fov, const Change& change) {
    return 2 * std::atan(change.zoom * std::tan(fov / 2));
}

}  // namespace

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Change* const change = contract::change();
    if (change == nullptr)
        return contract::ask<1, "pixel_on_screen">(pixel, resolution, vertical_fov);
    return contract::ask<1, "pixel_on_screen">(finer(pixel, *change), finer(resolution, *change),
                                               zoomed(vertical_fov, *change)) /
           change->zoom;
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Change* const change = contract::change();
    if (change == nullptr) return contract::ask<1, "camera_ray">(pixel, resolution, vertical_fov);
    Ray ray = contract::ask<1, "camera_ray">(finer(pixel, *change), finer(resolution, *change),
                                             zoomed(vertical_fov, *change));
    ray.direction.x /= change->zoom;
    ray.direction.y /= change->zoom;
    return ray;
}

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    const Change* const change = contract::change();
    if (change == nullptr)
        return contract::ask<1, "unprojected_ray">(pixel, camera_to_world, image_to_world);
    // The world moves, and the picture within a larger one.
    const Mat4 world = contract::matrix_of(change->any);
    Mat4 picture(1);
    picture[3] = Vec4(-change->finer, -change->finer, 0, 1);
    const Pixel shifted{.row = pixel.row + change->finer, .column = pixel.column + change->finer};
    return contract::moved_back(
        contract::ask<1, "unprojected_ray">(shifted, Mat4(world * camera_to_world),
                                            Mat4(world * image_to_world * picture)),
        change->any);
}

}  // namespace rt
