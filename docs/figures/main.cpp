// figures <folder>: writes every figure of the pages as <folder>/<name>.svg.
#include "docs/figures/figures.hpp"

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
    Figure{"screen_fov", screen_fov},
    Figure{"camera_basis", camera_basis_axes},
    Figure{"camera_unnormalised", camera_unnormalised},
    Figure{"sphere_roots", sphere_roots},
    Figure{"sphere_half_chord", sphere_half_chord},
    Figure{"plane_steps", plane_steps},
    Figure{"plane_horizon", plane_horizon},
    Figure{"triangle_half_planes", triangle_half_planes},
    Figure{"triangle_areas", triangle_areas},
    Figure{"triangle_shared_edge", triangle_shared_edge},
    Figure{"square_frame", square_frame},
    Figure{"square_one_sided", square_one_sided},
    Figure{"cylinder_cross_section", cylinder_cross_section},
    Figure{"cylinder_roots", cylinder_roots},
    Figure{"cone_roots", cone_roots},
    Figure{"cone_slope", cone_slope},
    Figure{"cone_erratum", cone_erratum},
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: figures <folder>\n";
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    for (const Figure& figure : all) {
        const std::filesystem::path file = folder / (std::string(figure.name) + ".svg");
        std::ofstream out(file, std::ios::binary);
        out << figure.draw() << std::flush;
        if (!out) {
            std::cerr << file.string() << ": error: cannot be written\n";
            return 2;
        }
    }
}
