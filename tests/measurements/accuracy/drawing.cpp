#include "tests/measurements/accuracy/drawing.hpp"

#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/countdown.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace rt {

namespace {

Scene loaded(const std::string& file, Resolution size, std::size_t hierarchy_from) {
    Scene scene = load_scene(file, orthonormal_basis);
    load_meshes(scene);
    Acceleration how;
    if (hierarchy_from > 0) how.hierarchy_from = hierarchy_from;
    build_acceleration(scene, how);
    scene.resolution = size;
    return scene;
}

Drawing timed(const Scene& scene, const RenderSettings& settings) {
    Drawing drawing;
    const double start = cpu_seconds();
    drawing.image = std::move(render(scene, {.settings = settings}).value().image);
    drawing.seconds = cpu_seconds() - start;
    return drawing;
}

}  // namespace

Drawer RT_PRECISION::drawer(const std::string& file, Resolution size, std::size_t hierarchy_from) {
    const auto scene = std::make_shared<const Scene>(loaded(file, size, hierarchy_from));
    return [scene](const RenderSettings& settings) { return timed(*scene, settings); };
}

Drawing RT_PRECISION::drawn(const std::string& file, Resolution size,
                            const RenderSettings& settings, std::size_t hierarchy_from) {
    return timed(loaded(file, size, hierarchy_from), settings);
}

Drawing RT_PRECISION::rendered(const std::string& file, Resolution size,
                               const RenderSettings& settings) {
    const Scene scene = loaded(file, size, 0);
    // Processor time, the shortest of several runs, since other processes may use the machine too.
    Drawing drawing{.seconds = std::numeric_limits<double>::infinity()};
    for (double all = 0; all < 0.3;) {
        Drawing run = timed(scene, settings);
        all += run.seconds;
        run.seconds = std::min(run.seconds, drawing.seconds);
        drawing = std::move(run);
    }
    return drawing;
}

}  // namespace rt
