#include "tests/kit/picture.hpp"

#include "common/contract/rendered.hpp"
#include "common/image/png.hpp"
#include "common/program/load_meshes.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <cstdlib>

namespace rt {

namespace {

constexpr int rounding = 1;  // a color near n + ½ may be rounded up or down
constexpr std::uint8_t not_judged = 255;

std::string text(Pixel pixel) {
    return std::to_string(pixel.row) + "," + std::to_string(pixel.column);
}

}  // namespace

std::string text(Rgb color) {
    return std::to_string(color[0]) + ", " + std::to_string(color[1]) + ", " +
           std::to_string(color[2]);
}

bool fits(Rgb got, Rgb reference, Rgb spread) {
    for (std::size_t i = 0; i < got.size(); ++i)
        if (spread[i] != not_judged && std::abs(got[i] - reference[i]) > spread[i] + rounding)
            return false;
    return true;
}

std::string project_file(const std::string& name) {
    return RAYSTEPS_ROOT "/" + name;
}

Verdict picture_matches(const std::string& name, const Drawing& drawing) {
    const std::string scene_name = drawing.scene.empty() ? name : drawing.scene;
    const Image reference = read_png(project_file("docs/pictures/" + name + ".png"));
    const Image spread = read_png(project_file("tests/programs/pictures/" + scene_name + ".png"));
    Scene scene = load_scene(project_file("scenes/" + scene_name + ".rt"), orthonormal_basis,
                             {.strict = true});
    load_meshes(scene);
    // As stages 3 to 8 draw it: a wrong hit outside of the shape's bounding sphere is seen.
    build_acceleration(scene, {.balls = false});
    scene.resolution = reference.resolution;
    const Image image = rendered(scene, drawing.settings, drawing.every);

    int different = 0;
    std::string first;
    for (Pixel pixel; pixel.row < image.resolution.height; pixel.row += drawing.every) {
        for (pixel.column = 0; pixel.column < image.resolution.width;
             pixel.column += drawing.every) {
            const Rgb got = image[pixel];
            if (fits(got, reference[pixel], spread[pixel]) || different++ > 0) continue;
            first = "\n  first:    row,column " + text(pixel) + "\n  got:      " + text(got) +
                    "\n  expected: " + text(reference[pixel]) + "\n  see:      ./course explain " +
                    name + " " + text(pixel);
        }
    }
    return verdict(different == 0, "The picture of scenes/" + scene_name + ".rt differs in " +
                                       std::to_string(different) + " pixels." + first);
}

}  // namespace rt
