#include "tests/kit/picture.hpp"

#include "common/mesh_loading.hpp"
#include "common/png.hpp"
#include "common/render.hpp"
#include "common/scene_reader.hpp"

#include <algorithm>

namespace rt {

namespace {

constexpr int rounding = 1;
/// Where two edges meet, a surface shows through a gap narrower than a pixel: there a ray's last
/// digit decides for a colour that no neighbour has. Our scenes have a handful of such pixels; a
/// picture that is wrong differs in hundreds.
constexpr int through_gaps = 8;

std::string text(Rgb color) {
    return std::to_string(color[0]) + ", " + std::to_string(color[1]) + ", " +
           std::to_string(color[2]);
}

std::string text(Pixel pixel) {
    return std::to_string(pixel.row) + "," + std::to_string(pixel.column);
}

/// Whether the colour lies among those of the pixel and its eight neighbours, give or take one.
bool fits(const Image& reference, Pixel pixel, Rgb color) {
    const auto [width, height] = reference.resolution;
    for (std::size_t i = 0; i < 3; ++i) {
        int low = 255;
        int high = 0;
        for (int row = std::max(pixel.row - 1, 0); row <= std::min(pixel.row + 1, height - 1);
             ++row)
            for (int column = std::max(pixel.column - 1, 0);
                 column <= std::min(pixel.column + 1, width - 1); ++column) {
                low = std::min<int>(low, reference[{row, column}][i]);
                high = std::max<int>(high, reference[{row, column}][i]);
            }
        if (color[i] < low - rounding || color[i] > high + rounding) return false;
    }
    return true;
}

}  // namespace

std::string project_file(const std::string& name) {
    return RAYSTEPS_ROOT "/" + name;
}

Verdict picture_matches(const std::string& name, int every) {
    const Image reference = read_png(project_file("docs/pictures/" + name + ".png"));
    Scene scene = load_scene(project_file("scenes/" + name + ".rt"), {.strict = true});
    load_meshes(scene);
    arrange(scene);
    const auto [width, height] = reference.resolution;
    const auto pixel_ray = pixel_rays(scene.cameras.front(), reference.resolution);

    Context context;
    int different = 0;
    std::string first;
    for (Pixel& pixel = context.pixel; pixel.row < height; pixel.row += every) {
        for (pixel.column = 0; pixel.column < width; pixel.column += every) {
            const Rgb came = to_rgb(trace(scene, pixel_ray(pixel), context));
            if (fits(reference, pixel, came) || different++ > 0) continue;
            first = "\n  first:    row,column " + text(pixel) + "\n  came:     " + text(came) +
                    "\n  expected: " + text(reference[pixel]) + "\n  see:      ./course run " +
                    name + " --pixel " + text(pixel);
        }
    }
    return verdict(different <= through_gaps, "The picture of scenes/" + name + ".rt differs in " +
                                                  std::to_string(different) + " pixels." + first);
}

}  // namespace rt
