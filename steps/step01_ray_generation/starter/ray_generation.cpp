// Stage 1, to be written. docs/step01_ray_generation.md explains it, the header is its contract.
// Begin with pixel_on_screen. camera_ray needs one more line, unprojected_ray is independent.
// `./course check 1` reports errors, `./course hint 1` prints the next hint.
#include "steps/step01_ray_generation/ray_generation.hpp"

#include "common/stages/todo.hpp"

#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    // pixFinal of MRT §1.
    RT_TODO(pixel, resolution, vertical_fov);
    return Vec2(0);
}

Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    // From the origin through the pixel's center on the plane z = −1.
    RT_TODO(pixel, resolution, vertical_fov);
    return {.origin = Vec3(0), .direction = Vec3(0, 0, -1)};
}

Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world, const Mat4& image_to_world) {
    // The same ray by inverse matrices: both ends, each divided by its w.
    RT_TODO(pixel, camera_to_world, image_to_world);
    return {.origin = Vec3(0), .direction = Vec3(0, 0, -1)};
}

}  // namespace rt
