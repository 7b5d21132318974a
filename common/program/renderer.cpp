#include "common/program/renderer.hpp"

#include "common/program/load_meshes.hpp"
#include "common/program/make_picture.hpp"
#include "common/program/requirements.hpp"
#include "common/program/used_options.hpp"
#include "common/render/render.hpp"
#include "common/stages/stages.hpp"
#include "common/system/countdown.hpp"
#include "common/system/escaping.hpp"
#include "common/system/translation.hpp"
#include "common/tuning/auto_settings.hpp"
#include "common/tuning/input_rounding.hpp"
#include "common/tuning/render_trials.hpp"
#include "common/tuning/trial_runner.hpp"
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

/// Prints warnings on the standard error; nothing with `--quiet`.
Warn warn_unless_quiet(const Options& options) {
    if (options.quiet) return nullptr;
    return [](const std::string& warning) { std::cerr << tr_text(warning) << '\n'; };
}

/// The acceleration structures of the program's stage. In the stages about shapes there are no
/// bounding spheres, so that a wrong formula is visible.
Acceleration acceleration_of(const Program& program, const Options& options) {
    return {.hierarchy_from = options.hierarchy_from, .balls = program.stage >= light_stage};
}

/// Reads the scene and its meshes, with the selected camera in front, and builds its acceleration
/// structures. Throws InputError if a file is wrong, if a later stage introduces what the scene
/// requires, or if the output is one of the meshes. With `--requirements` it only reads the scene.
Scene prepared_scene(const Program& program, const Options& options) {
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

void check_pixel(const std::string& option, Pixel pixel, Resolution size) {
    if (pixel.row >= size.height || pixel.column >= size.width)
        throw InputError({}, option + " " + std::to_string(pixel.row) + "," +
                                 std::to_string(pixel.column) +
                                 " is outside the picture, which is " + size_text(size));
}

/// Returns whether the rays through the centers of pixels with settings `a` are those of a picture
/// of settings `b`.
bool have_same_centers(RenderSettings a, const RenderSettings& b) {
    if (!begins_with_centers(b)) return false;
    a.pixel_samples = b.pixel_samples;
    a.pixel_error = b.pixel_error;
    return a == b;
}

/// Returns whether the settings, or those that are chosen, sample a light until an error is
/// reached.
bool samples_to_error(const Options& options) {
    const RenderSettings& settings = options.settings;
    if (settings.shadow_error > 0) return settings.shadow_samples == most_shadow_samples;
    const bool chosen = options.tolerance || options.time;
    return chosen && options.given.pixel_samples && !options.given.shadow_samples;
}

/// Throws InputError if a light with a size would be sampled a million times: a student's loop
/// takes all samples.
void refuse_endless_sampling(const Trials& trials, const Program& program, const Options& options) {
    if (program.stage < soft_shadow_stage || !samples_to_error(options)) return;
    RenderSettings settings = options.settings;
    settings.pixel_samples = 1;
    settings.pixel_error = 0;
    if (!trials.traits().sized_lights || stops_sampling(trials, settings)) return;
    const std::string stage = std::to_string(program.stage);
    throw InputError({}, "your trace takes all samples of a light, where " +
                             std::string(options.settings.shadow_error > 0
                                             ? "--shadow-error"
                                             : "--tolerance or --time with --samples") +
                             " needs one that stops: add --shadow-samples N, or --reference " +
                             stage + " to ./course");
}

class SceneRenderer : public Renderer {
public:
    SceneRenderer(const Program& program, const Options& options)
        : program_(program),
          settings_(options.settings),
          scene_(prepared_scene(program, options)) {}

    [[nodiscard]] Resolution resolution() const override { return scene_.resolution; }

    [[nodiscard]] SceneTraits traits() const override {
        return scene_traits(scene_, program_.stage, settings_);
    }

    [[nodiscard]] FineShapes fine_shapes() const override { return rt::fine_shapes(scene_); }

    [[nodiscard]] double smallest_gap() const override { return scene_lengths(scene_).gap; }

    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        return rt::render_pixels(scene_, settings, request);
    }

    [[nodiscard]] TrialHistories trace_histories(const RenderSettings& settings,
                                                 const TrialRequest& request) const override {
        return rt::trace_histories(scene_, settings, request);
    }

    [[nodiscard]] TrialCenters render_centers(const RenderSettings& settings,
                                              const TrialRequest& request) override {
        const double start = cpu_seconds();
        const Clock::time_point time = Clock::now();
        auto traced = rt::render_centers(
            scene_, {.threads = request.threads, .settings = settings, .stop = request.stop});
        if (!traced) return {};
        const std::chrono::duration<double> taken = Clock::now() - time;
        centers_ = {.rendering = *std::move(traced), .seconds = taken.count()};
        centers_settings_ = settings;
        const Rendering& centers = centers_->rendering;
        const auto pixels = double(centers.image.pixels.size());
        return {.image = &centers.image,
                .rays = double(centers.rays) / pixels,
                .seconds = (cpu_seconds() - start) / pixels};
    }

    [[nodiscard]] bool run(const Options& options, TimeBudget* pace,
                           const std::atomic<bool>& stop) override {
        if (options.requirements) {
            std::cout << one_line(options.scene) << explanation(scene_)
                      << mesh_forms(scene_, warn_unless_quiet(options));
        } else if (options.pixel) {
            check_pixel("--pixel", *options.pixel, scene_.resolution);
            explain_pixel(program_, options, scene_, *options.pixel);
        } else if (options.rays) {
            check_pixel("--rays", *options.rays, scene_.resolution);
            std::cout << ray_drawing(scene_, settings_, *options.rays) << '\n';
        } else if (options.turn) {
            return make_animation(program_, options, scene_, stop);
        } else {
            if (centers_ && !have_same_centers(centers_settings_, options.settings))
                centers_.reset();
            return make_picture(program_, options, scene_, centers_ ? &*centers_ : nullptr, pace,
                                stop);
        }
        return true;
    }

private:
    Program program_;
    RenderSettings settings_;
    Scene scene_;
    std::optional<TracedCenters> centers_;  ///< of trials
    RenderSettings centers_settings_;
};

}  // namespace

std::unique_ptr<Renderer> RT_PRECISION::make_renderer(const Program& program,
                                                      const Options& options) {
    auto renderer = std::make_unique<SceneRenderer>(program, options);
    if (!options.requirements) refuse_endless_sampling(*renderer, program, options);
    return renderer;
}

#ifndef RT_FLOAT
std::vector<std::string> f64::risks_in_float(const Options& options) {
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(options.scene, unreadable)) return {};
    SceneReading reading = options.reading;
    reading.warn = nullptr;
    return risks_in_float(scene_lengths(load_scene(options.scene, orthonormal_basis, reading)));
}
#endif

}  // namespace rt
