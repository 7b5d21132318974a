// The figures of the pages, each as the text of its SVG file.
#pragma once

#include <string>

namespace rt::figures {

std::string pixel_grid();
std::string screen_fov();

std::string camera_basis_axes();
std::string camera_unnormalised();

std::string sphere_roots();
std::string sphere_half_chord();

std::string plane_steps();
std::string plane_horizon();

std::string triangle_half_planes();
std::string triangle_areas();
std::string triangle_shared_edge();

std::string square_frame();
std::string square_one_sided();

std::string cylinder_cross_section();
std::string cylinder_roots();

std::string cone_roots();
std::string cone_slope();
std::string cone_erratum();

}  // namespace rt::figures
