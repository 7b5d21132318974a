// The corners of pixels.
#pragma once

#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt::figures {

/// The ray through the upper left corner of a pixel, half-way between two centers.
[[nodiscard]] inline Ray corner_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Ray before = camera_ray({pixel.row - 1, pixel.column - 1}, resolution, vertical_fov);
    const Ray here = camera_ray(pixel, resolution, vertical_fov);
    return {.origin = here.origin, .direction = (before.direction + here.direction) / Real(2)};
}

}  // namespace rt::figures
