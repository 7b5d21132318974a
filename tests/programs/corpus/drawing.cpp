#include "tests/programs/corpus/drawing.hpp"

#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/cpu_seconds.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <utility>

namespace rt {

Drawing RT_PRECISION::draw(const std::string& file, Resolution size) {
    Drawing drawing;
    try {
        const double start = cpu_seconds();
        Scene scene = load_scene(file, orthonormal_basis);
        load_meshes(scene);
        build_acceleration(scene);
        scene.resolution = size;
        auto rendering = render(scene, {.threads = 1});
        drawing.seconds = cpu_seconds() - start;
        drawing.not_a_number = rendering->not_a_number;
        drawing.image = std::move(rendering->image);
    } catch (const InputError& error) {
        drawing.refusal = error.what();
    }
    return drawing;
}

}  // namespace rt
