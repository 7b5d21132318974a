#include "common/program/prepared_scene.hpp"

#include "common/program/load_meshes.hpp"
#include "common/program/requirements.hpp"
#include "common/stages/stages.hpp"
#include "common/system/translation.hpp"
#include "common/tuning/input_rounding.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <filesystem>
#include <iostream>
#include <utility>

namespace rt {

namespace {

void refuse_later_stages(const Scene& scene, const Program& program, const Options& options) {
    const std::vector<Requirement> needs = requirements(scene, program.stage);
    if (needs.empty() || needs.back().stage <= program.stage) return;
    const auto& [what, stage] = needs.back();  // a program of this stage has the earlier ones too
    throw InputError({options.scene}, what + " in the scene, which " + name_of(stage) +
                                          " introduces: run that stage, or a later one");
}

/// Moves the selected camera to the front.
void choose_camera(Scene& scene, const Options& options) {
    const auto index = std::size_t(options.camera - 1);
    if (index < scene.cameras.size()) return std::swap(scene.cameras[0], scene.cameras[index]);
    const std::size_t count = scene.cameras.size();
    throw InputError({options.scene}, "has " + std::to_string(count) +
                                          (count == 1 ? " camera" : " cameras") +
                                          ", and no --camera " + std::to_string(options.camera));
}

/// Throws InputError if the output is a mesh of the scene: a mesh file that starts as a PNG does
/// could be overwritten.
void refuse_mesh_as_output(const Scene& scene, const Options& options) {
    for (const MeshRequest& mesh : scene.mesh_requests) {
        std::error_code not_there;
        if (std::filesystem::equivalent(path_of(mesh), options.output, not_there))
            throw InputError({options.output},
                             "is a mesh of the scene, which the picture would overwrite");
    }
}

/// Warns of what double loses. Of float the program warns before, with the numbers in double.
void warn_of_rounding([[maybe_unused]] const Scene& scene, [[maybe_unused]] const std::string& file,
                      [[maybe_unused]] const Warn& warn) {
#ifndef RT_FLOAT
    for (const std::string& risk : risks_in_double(scene_sizes(scene)))
        warn(to_string(FileLocation{file}) + "warning: " + risk + "; move or scale the scene");
#endif
}

}  // namespace

Warn RT_PRECISION::warn_unless_quiet(const Options& options) {
    if (options.quiet) return nullptr;
    return [](const std::string& warning) { std::cerr << tr_text(warning) << '\n'; };
}

Scene RT_PRECISION::prepared_scene(const Program& program, const Options& options) {
    SceneReading reading = options.reading;
    reading.warn = warn_unless_quiet(options);
    Scene scene = load_scene(options.scene, orthonormal_basis, reading);
    choose_camera(scene, options);
    if (options.size) scene.resolution = *options.size;
    if (options.requirements) return scene;
    refuse_later_stages(scene, program, options);
    if (options.makes_picture()) refuse_mesh_as_output(scene, options);
    load_meshes(scene, reading.warn);
    if (reading.warn) warn_of_rounding(scene, options.scene, reading.warn);
    build_acceleration(scene, acceleration_of(program, options));
    return scene;
}

Acceleration RT_PRECISION::acceleration_of(const Program& program, const Options& options) {
    return {.hierarchy_from = options.hierarchy_from, .balls = program.stage >= light_stage};
}

}  // namespace rt
