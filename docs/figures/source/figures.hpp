// The figures of the pages, each as the text of its SVG file.
#pragma once

#include <string>

namespace rt::figures {

std::string pixel_grid();
std::string screen_side_view();

std::string camera_axes();
std::string unnormalized_x();

std::string sphere_roots();
std::string sphere_half_chord();

std::string plane_lengths();
std::string plane_horizon();

std::string triangle_half_planes();
std::string triangle_areas();
std::string triangle_shared_edge();

std::string square_frame();
std::string cornell_from_above();

std::string cylinder_section();
std::string cylinder_both_roots();

std::string cone_side();
std::string cone_slope();
std::string cone_coefficient();

std::string phong_vectors();
std::string phong_behind();
std::string phong_highlight();

std::string shadow_range();
std::string shadow_offset();

std::string soft_shadow_regions();
std::string soft_shadow_samples();
std::string soft_shadow_penumbra();

std::string mirror_direction();
std::string mirror_facing();
std::string mirror_interpolated();

std::string box_slabs();
std::string mesh_frame();
std::string mesh_hierarchy();

std::string pixel_points();

}  // namespace rt::figures
