#include "tests/corpus/drawing.hpp"

#include "common/render.hpp"
#include "common/scene_reader.hpp"

#include <ctime>
#include <utility>

namespace rt {

Drawing RT_PRECISION::draw(const std::string& file, Resolution size) {
    Drawing drawing;
    try {
        Scene scene = load_scene(file);
        scene.resolution = size;
        const std::clock_t start = std::clock();
        auto rendering = render(scene, {.threads = 1});
        drawing.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        drawing.not_a_number = rendering->not_a_number;
        drawing.image = std::move(rendering->image);
    } catch (const InputError& error) {
        drawing.refusal = error.what();
    }
    return drawing;
}

}  // namespace rt
