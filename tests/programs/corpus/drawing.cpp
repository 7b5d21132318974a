#include "tests/programs/corpus/drawing.hpp"

#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <ctime>
#include <utility>

namespace rt {

Drawing RT_PRECISION::draw(const std::string& file, Resolution size) {
    Drawing drawing;
    try {
        const std::clock_t start = std::clock();
        Scene scene = load_scene(file, orthonormal_basis);
        load_meshes(scene);
        build_acceleration(scene);
        scene.resolution = size;
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
