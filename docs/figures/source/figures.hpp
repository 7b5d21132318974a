// The figures of the pages, each as the text of its SVG file.
#pragma once

#include "steps/step01_ray_generation/ray_generation.hpp"

#include <string>

namespace rt::figures {

std::string pixel_grid();

std::string camera_axes();

std::string sphere_half_chord();

std::string plane_lengths();

std::string triangle_half_planes();

std::string cornell_from_above();

std::string cylinder_section();

std::string cone_slope();
std::string cone_coefficient();

std::string phong_behind();
std::string phong_highlight();

std::string shadow_range();
std::string shadow_start();

std::string soft_shadow_regions();
std::string soft_shadow_penumbra();

std::string mirror_direction();
std::string mirror_interpolated();

// The corners of pixels.

/// The ray through the upper left corner of a pixel, half-way between two centers.
[[nodiscard]] inline Ray corner_ray(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Ray before = camera_ray({pixel.row - 1, pixel.column - 1}, resolution, vertical_fov);
    const Ray here = camera_ray(pixel, resolution, vertical_fov);
    return {.origin = here.origin, .direction = (before.direction + here.direction) / Real(2)};
}

}  // namespace rt::figures
