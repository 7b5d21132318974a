// The figures of the pages, each as the text of its SVG file.
#pragma once

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

}  // namespace rt::figures
