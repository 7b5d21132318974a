// Writes the figures of the pages: figures FOLDER
#include "docs/figures/figures.hpp"

#include "common/input_error.hpp"

#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: figures FOLDER\n";
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    try {
        rt::pixel_grid().write(folder + "pixel_grid.svg");
        rt::screen_side_view().write(folder + "screen_side_view.svg");
        rt::camera_axes().write(folder + "camera_axes.svg");
        rt::unnormalised_x().write(folder + "unnormalised_x.svg");
        rt::sphere_roots().write(folder + "sphere_roots.svg");
        rt::sphere_half_chord().write(folder + "sphere_half_chord.svg");
        rt::plane_lengths().write(folder + "plane_lengths.svg");
        rt::plane_horizon().write(folder + "plane_horizon.svg");
        rt::triangle_half_planes().write(folder + "triangle_half_planes.svg");
        rt::triangle_areas().write(folder + "triangle_areas.svg");
        rt::triangle_shared_edge().write(folder + "triangle_shared_edge.svg");
        rt::square_frame().write(folder + "square_frame.svg");
        rt::cornell_from_above().write(folder + "cornell_from_above.svg");
        rt::cylinder_section().write(folder + "cylinder_section.svg");
        rt::cylinder_both_roots().write(folder + "cylinder_both_roots.svg");
        rt::cone_side().write(folder + "cone_side.svg");
        rt::cone_coefficient().write(folder + "cone_coefficient.svg");
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return 0;
}
