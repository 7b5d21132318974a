// One function a figure; each asks the project's own functions where things are.
#pragma once

#include "docs/figures/svg.hpp"

namespace rt {

Svg pixel_grid();
Svg screen_side_view();
Svg camera_axes();
Svg unnormalised_x();
Svg sphere_roots();
Svg sphere_half_chord();
Svg plane_lengths();
Svg plane_horizon();
Svg triangle_half_planes();
Svg triangle_areas();
Svg triangle_shared_edge();
Svg square_frame();
Svg cornell_from_above();
Svg cylinder_section();
Svg cylinder_both_roots();
Svg cone_side();
Svg cone_coefficient();

}  // namespace rt
