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
    Figure{"camera_axes", camera_axes},
    Figure{"sphere_half_chord", sphere_half_chord},
    Figure{"plane_lengths", plane_lengths},
    Figure{"triangle_half_planes", triangle_half_planes},
    Figure{"cornell_from_above", cornell_from_above},
    Figure{"cylinder_section", cylinder_section},
    Figure{"cone_slope", cone_slope},
    Figure{"cone_coefficient", cone_coefficient},
    Figure{"phong_behind", phong_behind},
    Figure{"phong_highlight", phong_highlight},
    Figure{"shadow_range", shadow_range},
    Figure{"shadow_start", shadow_start},
    Figure{"soft_shadow_regions", soft_shadow_regions},
    Figure{"soft_shadow_penumbra", soft_shadow_penumbra},
    Figure{"mirror_direction", mirror_direction},
    Figure{"mirror_interpolated", mirror_interpolated},
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
