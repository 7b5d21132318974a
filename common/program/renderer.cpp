#include "common/program/renderer.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/image/animation.hpp"
#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/program/blank_picture.hpp"
#include "common/program/load_meshes.hpp"
#include "common/program/ray_drawing.hpp"
#include "common/program/requirements.hpp"
#include "common/program/shade_picture.hpp"
#include "common/program/turntable.hpp"
#include "common/program/used_options.hpp"
#include "common/render/pixel_samples.hpp"
#include "common/render/render.hpp"
#include "common/stages/stages.hpp"
#include "common/system/cpu_seconds.hpp"
#include "common/system/terminal.hpp"
#include "common/tuning/input_rounding.hpp"
#include "common/tuning/render_trials.hpp"
#include "common/tuning/scene_traits.hpp"
#include "common/tuning/stops_sampling.hpp"
#include "common/tuning/time_budget.hpp"
#include "common/tuning/wording.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <utility>

namespace rt {

namespace {

std::string size_text(Resolution size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void refuse_later_stages(const Scene& scene, const Program& program, const Options& options) {
    const std::vector<Requirement> needs = requirements(scene, program.stage);
    if (needs.empty() || needs.back().stage <= program.stage) return;
    const auto& [what, stage] = needs.back();  // a program of this stage has the earlier ones too
    throw InputError({options.scene}, what + " in the scene, which " + name_of(stage) +
                                          " introduces: run that stage, or a later one");
}

/// In the stages about shapes there are no bounding spheres, so that a wrong formula is visible.
Acceleration arrangement(const Program& program, const Options& options) {
    return {.hierarchy_from = options.hierarchy_from, .balls = program.stage >= light_stage};
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

Scene load(const Program& program, const Options& options) {
    SceneReading reading = options.reading;
    if (!options.quiet)
        reading.warn = [](const std::string& warning) { std::cerr << warning << '\n'; };
    Scene scene = load_scene(options.scene, orthonormal_basis, reading);
    choose_camera(scene, options);
    if (options.size) scene.resolution = *options.size;
    if (options.requirements) return scene;
    refuse_later_stages(scene, program, options);
    if (options.makes_picture()) refuse_mesh_as_output(scene, options);
    load_meshes(scene, reading.warn);
    if (reading.warn) warn_of_rounding(scene, options.scene, reading.warn);
    build_acceleration(scene, arrangement(program, options));
    return scene;
}

/// The metadata of the picture: everything that determined it. The number of threads does not
/// affect it.
std::vector<PngText> texts(const Program& program, const Options& options, Resolution size) {
    const bool is_float = options.precision == Precision::f32;
    const std::string used =
        is_float ? equivalent_options(program, options) : used_options(program, options);
    return {{"Title", std::filesystem::path(options.scene).filename().string()},
            {"Software", "Raysteps " + name_of(program.stage)},
            {"Size", size_text(size)},
            {"Precision", name(options.precision)},
            {"Options", used}};
}

void report(const Rendering& rendering, const Options& options, const TimeBudget* pace,
            double seconds) {
    std::printf("%s: %s pixels, %s, %.2f s, %lld rays", options.output.c_str(),
                size_text(rendering.image.resolution).c_str(), name(options.precision), seconds,
                static_cast<long long>(rendering.rays));
    if (rendering.sized_light_rays > 0)
        std::printf(", %lld of them to lights with a size",
                    static_cast<long long>(rendering.sized_light_rays));
    if (pace != nullptr)
        std::printf("; 99 of 100 pixels within %s of 255, according to the trials",
                    number(pace->error()).c_str());
    std::printf("\n");
    if (rendering.not_a_number == 0) return;
    const Pixel first = rendering.first_not_a_number;
    const bool one = rendering.not_a_number == 1;
    std::printf("%lld %s not a number, and shown in magenta: see --pixel %d,%d\n",
                static_cast<long long>(rendering.not_a_number), one ? "pixel is" : "pixels are",
                first.row, first.column);
}

/// Renders the picture, or that of the numbers of --shade, whose legend is added.
std::optional<Rendering> rendering_of(const Scene& scene, const Options& options,
                                      const RenderJob& job, std::vector<std::string>& legend) {
    if (!shows_number(options.settings.shading)) return render(scene, job);
    const auto values = pixel_values(scene, job);
    if (!values) return std::nullopt;
    ShadePicture picture = shade_picture(*values, options, scene);
    legend = std::move(picture.legend);
    Rendering rendering{.rays = values->rays, .sized_light_rays = values->sized_light_rays};
    rendering.image = std::move(picture.image);
    return rendering;
}

/// Warns if the picture has a single color, with the reason.
void warn_if_blank(const Scene& scene, const Program& program, const Options& options,
                   const Image& image) {
    if (program.stage < shapes_stage) return;
    const std::string reason = why_blank(scene, options.settings, program.stage, image);
    if (!reason.empty())
        std::cerr << to_string(FileLocation{options.scene}) << "warning: " << reason << '\n';
}

bool make_picture(const Program& program, const Options& options, const Scene& scene,
                  Rendering* centers, TimeBudget* pace, const std::atomic<bool>& stop) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::string> legend;
    std::optional<Rendering> rendering;
    {
        Progress progress(!options.quiet && errors_on_terminal(), scene.resolution.height);
        RenderJob job{.threads = options.threads,
                      .settings = options.settings,
                      .row_done = [&progress] { progress.advance(); },
                      .centers = centers,
                      .stop = &stop};
        if (pace != nullptr) job.next_settings = [pace] { return pace->next(); };
        rendering = rendering_of(scene, options, job, legend);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (!rendering) return false;
    std::vector<PngText> metadata = texts(program, options, scene.resolution);
    for (const std::string& line : legend) metadata.push_back({"Legend", line});
    write_png(options.output, rendering->image, metadata,
              legend.empty() ? options.settings.gamma : Gamma::unstated);
    if (options.preview) std::fputs(preview(rendering->image, terminal_columns()).c_str(), stdout);
    if (!options.quiet && legend.empty()) warn_if_blank(scene, program, options, rendering->image);
    if (options.quiet) return true;
    report(*rendering, options, pace, seconds.count());
    for (const std::string& line : legend) std::printf("  %s\n", line.c_str());
    return true;
}

/// Renders the frames of `--turn` to an animated PNG.
bool make_animation(const Program& program, const Options& options, const Scene& scene,
                    const std::atomic<bool>& stop) {
    constexpr int milliseconds = 5000;  // for the whole way around
    const std::optional<Vec3> middle = middle_of_shapes(scene);
    if (!middle)
        throw InputError({options.scene},
                         "has no shape but planes: --turn needs another, to go around it");
    const auto start = std::chrono::steady_clock::now();
    const int frames = *options.turn;
    Scene turning = scene;
    Animation animation;
    {
        Progress progress(!options.quiet && errors_on_terminal(), frames * scene.resolution.height);
        for (int frame = 0; frame < frames; ++frame) {
            turning.cameras[0] = turned(scene.cameras[0], *middle, Real(frame) / Real(frames));
            const auto rendering = render(turning, {.threads = options.threads,
                                                    .settings = options.settings,
                                                    .row_done = [&] { progress.advance(); },
                                                    .stop = &stop});
            if (!rendering) return false;
            animation.add(rendering->image);
        }
    }
    animation.write(options.output, milliseconds / frames,
                    texts(program, options, scene.resolution), options.settings.gamma);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (!options.quiet)
        std::printf("%s: %d frames of %s pixels, %s, %.2f s\n", options.output.c_str(), frames,
                    size_text(scene.resolution).c_str(), name(options.precision), seconds.count());
    return true;
}

std::string bytes_text(Rgb rgb) {
    return std::to_string(rgb[0]) + ", " + std::to_string(rgb[1]) + ", " + std::to_string(rgb[2]);
}

/// Logs the color that the picture has with --samples. The rest of the log is that of the ray
/// through the pixel's center, which is none of the samples.
void log_mean(PixelLog& log, const RenderSettings& settings, const Scene& scene, Pixel pixel) {
    Context context{.settings = shared_settings(settings), .pixel = pixel};
    const FinerRays rays(scene.cameras.front(), scene.resolution);
    const Color mean = mean_color(scene, rays, pixel, context);
    log.heading("The mean of " + std::to_string(settings.pixel_samples) +
                " other rays through the pixel, which the picture has");
    log.line("color", text(mean));
    log.line("8-bit", bytes_text(to_rgb(mean, settings.gamma)));
}

void check_pixel(const std::string& option, Pixel pixel, Resolution size) {
    if (pixel.row >= size.height || pixel.column >= size.width)
        throw InputError({}, option + " " + std::to_string(pixel.row) + "," +
                                 std::to_string(pixel.column) +
                                 " is outside the picture, which is " + size_text(size));
}

void explain_pixel(const Program& program, const Options& options, const Scene& scene,
                   Pixel pixel) {
    const Resolution size = scene.resolution;
    check_pixel("--pixel", pixel, size);
    const Camera& camera = scene.cameras.front();
    PixelLog log(std::cout);
    log.heading(name_of(program.stage) + ", " + options.scene + ", " + size_text(size) +
                " pixels, " + name(options.precision));
    explain_screen(log, pixel, size, vertical_fov(camera, size));
    if (program.stage >= 2) explain_basis(log, camera);
    const Ray ray = pixel_rays(camera, size)(pixel);
    log.heading("The ray");
    log.line("o_r", text(ray.origin));
    log.line("d_r", text(ray.direction));
    const Watch watch{.log = &log};
    Context context{.settings = options.settings, .pixel = pixel, .log = &log, .watch = &watch};
    const Color color = trace(scene, ray, context);
    if (log.misses_left_out() > 0)
        log.remark(std::to_string(log.misses_left_out()) + " more shapes were missed");
    log.heading("The pixel");
    log.line("color", text(color));
    log.line("8-bit", bytes_text(to_rgb(color, options.settings.gamma)));
    if (options.settings.pixel_error > 0)
        log.remark("in the picture, a pixel beside an edge has the mean of more rays");
    else if (options.settings.pixel_samples > 1)
        log_mean(log, options.settings, scene, pixel);
}

/// Returns whether the rays through the centers of pixels are the same with both settings.
bool have_same_centers(RenderSettings a, const RenderSettings& b) {
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
          arrangement_(arrangement(program, options)),
          scene_(load(program, options)) {}

    [[nodiscard]] Resolution resolution() const override { return scene_.resolution; }

    [[nodiscard]] SceneTraits traits() const override {
        return scene_traits(scene_, program_.stage, settings_);
    }

    [[nodiscard]] double smallest_gap() const override { return scene_lengths(scene_).gap; }

    void build_acceleration(std::size_t hierarchy_from) override {
        Acceleration how = arrangement_;
        how.hierarchy_from = hierarchy_from;
        rt::build_acceleration(scene_, how);
    }

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
        centers_ = rt::render_centers(
            scene_, {.threads = request.threads, .settings = settings, .stop = request.stop});
        if (!centers_) return {};
        centers_settings_ = settings;
        const auto pixels = double(centers_->image.pixels.size());
        return {.image = &centers_->image,
                .rays = double(centers_->rays) / pixels,
                .seconds = (cpu_seconds() - start) / pixels};
    }

    [[nodiscard]] bool run(const Options& options, TimeBudget* pace,
                           const std::atomic<bool>& stop) override {
        if (options.requirements) {
            std::cout << options.scene << explanation(scene_);
        } else if (options.pixel) {
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
    Acceleration arrangement_;
    Scene scene_;
    std::optional<Rendering> centers_;  ///< of trials
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
