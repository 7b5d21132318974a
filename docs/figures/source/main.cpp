// figures <folder>: writes every figure of the pages as <folder>/<name>.svg.
#include "docs/figures/source/figures.hpp"

#include "common/system/input_error.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

struct Figure {
    const char* name;
    std::string (*draw)();
};

using namespace rt::figures;

constexpr std::array all = {
    Figure{"pixel_grid", pixel_grid},
    Figure{"screen_side_view", screen_side_view},
    Figure{"camera_axes", camera_axes},
    Figure{"unnormalized_x", unnormalized_x},
    Figure{"sphere_roots", sphere_roots},
    Figure{"sphere_half_chord", sphere_half_chord},
    Figure{"plane_lengths", plane_lengths},
    Figure{"plane_horizon", plane_horizon},
    Figure{"triangle_half_planes", triangle_half_planes},
    Figure{"triangle_areas", triangle_areas},
    Figure{"triangle_shared_edge", triangle_shared_edge},
    Figure{"square_frame", square_frame},
    Figure{"cornell_from_above", cornell_from_above},
    Figure{"cylinder_section", cylinder_section},
    Figure{"cylinder_both_roots", cylinder_both_roots},
    Figure{"cone_side", cone_side},
    Figure{"cone_slope", cone_slope},
    Figure{"cone_coefficient", cone_coefficient},
    Figure{"phong_vectors", phong_vectors},
    Figure{"phong_behind", phong_behind},
    Figure{"phong_highlight", phong_highlight},
    Figure{"shadow_range", shadow_range},
    Figure{"shadow_offset", shadow_offset},
    Figure{"soft_shadow_regions", soft_shadow_regions},
    Figure{"soft_shadow_samples", soft_shadow_samples},
    Figure{"soft_shadow_penumbra", soft_shadow_penumbra},
    Figure{"mirror_direction", mirror_direction},
    Figure{"mirror_facing", mirror_facing},
    Figure{"mirror_interpolated", mirror_interpolated},
    Figure{"box_slabs", box_slabs},
    Figure{"mesh_frame", mesh_frame},
    Figure{"mesh_hierarchy", mesh_hierarchy},
    Figure{"pixel_points", pixel_points},
};

/// Throws InputError if a file cannot be written, or a scene cannot be read.
void write_all(const std::filesystem::path& folder) {
    std::error_code failed;  // if there is no folder, no file can be written
    std::filesystem::create_directories(folder, failed);
    for (const Figure& figure : all) {
        const std::filesystem::path file = folder / (std::string(figure.name) + ".svg");
        std::ofstream out(file, std::ios::binary);
        out << figure.draw() << std::flush;
        if (!out) throw rt::InputError({.file = file.string()}, "cannot be written");
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: figures <folder>\n";
        return 2;
    }
    try {
        write_all(arguments[1]);
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
