// ask_picture WORKER STAGE OUT.png
//
// Renders the stage's scene with a worker, every fourth pixel of every fourth row. Prints the
// number of pixels, and the number that differs from right answers; writes them beside the
// reference's.
#include "tests/kit/picture.hpp"

#include "common/contract/asking.hpp"
#include "common/contract/picture_question.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/image/png.hpp"
#include "common/program/load_meshes.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <iostream>

namespace {

using namespace rt;

constexpr int every = 4;
constexpr double longest = 5;  // limit of the worker's computing time in seconds

/// The pixels that were drawn, as a picture of their own.
Image thinned(const Image& image) {
    const auto [width, height] = image.resolution;
    Image small({(width + every - 1) / every, (height + every - 1) / every});
    for (Pixel pixel; pixel.row < small.resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < small.resolution.width; ++pixel.column)
            small[pixel] = image[{pixel.row * every, pixel.column * every}];
    return small;
}

Image asked_of(const std::string& program, const Scene& scene) {
    contract::Worker worker(program);
    const std::string question = contract::picture_question(scene, {}, every);
    return contract::picture_in(worker.ask(question, longest), scene.resolution);
}

void ask(const std::string& program, const std::string& stage, const std::string& file) {
    const Image reference = read_png(project_file("docs/pictures/" + stage + ".png"));
    const Image spread =
        thinned(read_png(project_file("tests/programs/pictures/" + stage + ".png")));
    Scene scene =
        load_scene(project_file("scenes/" + stage + ".rt"), orthonormal_basis, {.strict = true});
    load_meshes(scene);
    scene.resolution = reference.resolution;
    const Image mine = thinned(asked_of(program, scene));
    const Image expected = thinned(reference);
    int different = 0;
    for (std::size_t i = 0; i < mine.pixels.size(); ++i)
        if (!fits(mine.pixels[i], expected.pixels[i], spread.pixels[i])) ++different;
    write_png(file, compare(mine, expected).side_by_side, {});
    std::cout << mine.pixels.size() << ' ' << different << '\n';
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count != 4) throw std::runtime_error("ask_picture WORKER STAGE OUT.png");
        ask(words[1], words[2], words[3]);
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
