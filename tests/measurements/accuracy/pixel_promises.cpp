// Measures the promise of --tolerance about the rays through pixels, and its cost. The picture of
// each scene with the chosen settings is compared with one of 1,024 rays through each pixel, each
// with 16 to a light with a size. The share of pixels in which that is off by more than half of the
// tolerance is estimated, from pixels with other random numbers. The rays of the trials and of the
// picture, and the processor time from the scene's file to the picture's, are given in units of
// those of the fastest settings found that keep the same promise; the last column is the time of
// the picture alone, without trials, beside that of the fastest settings with no more pixels off.
// The arguments are the tolerance, one scene (the file, a name, or "all"), and the width.
#include "common/program/load_meshes.hpp"
#include "common/program/renderer.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/countdown.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/render_trials.hpp"
#include "common/tuning/trial_pixels.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/accuracy/time_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>

using namespace rt;

namespace {

Resolution size{.width = 640, .height = 480};
const Program program{.stage = 13, .root = RAYSTEPS_ROOT};
const std::atomic<bool> going_on = false;

/// The scene of the program, with the rays of trials counted.
class CountedTrials : public Trials {
public:
    explicit CountedTrials(Trials& scene) : scene_(scene) {}

    [[nodiscard]] Resolution resolution() const override { return scene_.resolution(); }
    [[nodiscard]] SceneTraits traits() const override { return scene_.traits(); }
    [[nodiscard]] double smallest_gap() const override { return scene_.smallest_gap(); }
    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        TrialSample sample = scene_.render_pixels(settings, request);
        rays_ += sample.rays * double(request.pixels.size());
        return sample;
    }
    [[nodiscard]] TrialHistories trace_histories(const RenderSettings& settings,
                                                 const TrialRequest& request) const override {
        TrialHistories histories = scene_.trace_histories(settings, request);
        rays_ += histories.rays;
        return histories;
    }
    [[nodiscard]] FineShapes fine_shapes() const override { return scene_.fine_shapes(); }
    [[nodiscard]] TrialCenters render_centers(const RenderSettings& settings,
                                              const TrialRequest& request) override {
        return scene_.render_centers(settings, request);  // a part of the picture
    }

    [[nodiscard]] double rays() const { return rays_; }

private:
    Trials& scene_;
    mutable double rays_ = 0;
};

/// The largest difference of a component.
int difference(const Rgb& a, const Rgb& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// A picture beside the right one.
struct Outcome {
    double beyond = 0;      ///< share of the pixels off by more than the tolerance
    double worst_tile = 0;  ///< largest mean difference of a tile
    double rays = 0;
    double seconds = 0;

    [[nodiscard]] bool keeps(double tolerance, double share) const {
        return beyond <= share && worst_tile <= 2 * tolerance;
    }
};

class Subject {
public:
    Subject(const std::filesystem::path& file, double tolerance)
        : tolerance_(tolerance), scene_(load_scene(file.string(), orthonormal_basis)) {
        load_meshes(scene_);
        build_acceleration(scene_, {});
        scene_.resolution = size;
        sized_lights_ =
            std::ranges::any_of(scene_.lights, [](const Light& light) { return light.radius > 0; });
        RenderSettings right{.pixel_samples = 1024, .depth = 64};
        if (sized_lights_) right = with_rays(right, 16 * 32);  // the root of 1,024 is 32
        exact_ = render(scene_, {.settings = right}).value().image;
        exact_off_ = exact_off(right);
    }

    /// The estimated share of pixels in which the yardstick is off by more than half of the
    /// tolerance: the difference of two pictures is √2 times the error of each.
    [[nodiscard]] double exact_off() const { return exact_off_; }

    [[nodiscard]] Outcome outcome(const RenderSettings& settings) const {
        const double start = cpu_seconds();
        const Rendering rendering = render(scene_, {.settings = settings}).value();
        Outcome outcome{.rays = double(rendering.rays), .seconds = cpu_seconds() - start};
        std::map<int, std::pair<double, int>> tiles;
        for (Pixel pixel; pixel.row < size.height; ++pixel.row)
            for (pixel.column = 0; pixel.column < size.width; ++pixel.column) {
                const int off = difference(rendering.image[pixel], exact_[pixel]);
                outcome.beyond += off > tolerance_;
                auto& [sum, count] = tiles[tile_of(pixel, size)];
                sum += off;
                ++count;
            }
        outcome.beyond /= double(exact_.pixels.size());
        for (const auto& [tile, sums] : tiles)
            outcome.worst_tile = std::max(outcome.worst_tile, sums.first / sums.second);
        return outcome;
    }

    /// The fastest settings found with which at most this share of a picture's pixels is off, and
    /// their rays: one ray for each pixel, or a --pixel-error in steps of an eighth of an octave
    /// with up to 8 to 1,024 rays, with 4, 8, 16, 32 or 64 rays to a light.
    [[nodiscard]] std::pair<RenderSettings, double> fastest(RenderSettings settings,
                                                            double share) const {
        std::pair found{settings, 0.0};
        double least = std::numeric_limits<double>::infinity();
        const auto keeps = [&](const Outcome& it) {
            if (!it.keeps(tolerance_, share)) return false;
            if (it.seconds < least) {
                least = it.seconds;
                found = {settings, it.rays};
            }
            return true;
        };
        settings.shadow_error = settings.shadow_agree = 0;
        for (const int shadow_samples : {32, 16, 64, 8, 4}) {
            if (!sized_lights_ && shadow_samples != 4) continue;
            settings.shadow_samples = shadow_samples;
            settings.pixel_samples = 1;
            settings.pixel_error = 0;
            if (keeps(outcome(settings))) continue;
            settings.pixel_error = 32 * tolerance_;
            for (int most = 1024; most >= 8; most /= 2) {
                settings.pixel_samples = most;  // fewer need a smaller error
                for (; settings.pixel_error > tolerance_ / 8;
                     settings.pixel_error /= std::pow(2, 0.125)) {
                    const Outcome it = outcome(settings);
                    if (keeps(it) || it.seconds > least) break;  // smaller errors take longer
                }
            }
        }
        return found;
    }

private:
    [[nodiscard]] double exact_off(const RenderSettings& right) const {
        constexpr std::size_t enough = 500;
        const std::vector<Pixel> pixels = some_of(SpreadPixels(size).pixels(), enough);
        const TrialSample other =
            render_pixels(scene_, right, {.pixels = pixels, .round = 1, .stop = &going_on});
        int beyond = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            beyond += distance(other.shades[i], display_color(exact_[pixels[i]])) >
                      tolerance_ / std::numbers::sqrt2 + 0.5;  // the yardstick is rounded
        return beyond / double(pixels.size());
    }

    double tolerance_;
    Scene scene_;
    bool sized_lights_ = false;
    Image exact_;
    double exact_off_ = 0;
};

/// The processor time from the scene's file to the picture's. With a tolerance, the trials are
/// a part of it.
Drawing whole_time(Options options) {
    options.threads = 1;
    options.quiet = true;
    options.output = (std::filesystem::temp_directory_path() / "pixel_promises.png").string();
    const double start = cpu_seconds();
    auto session = f64::make_renderer(program, options);
    if (options.tolerance) {
        std::unique_ptr<Renderer> in_float;
        const OpenFloat open_float = [&]() -> Trials& {
            return *(in_float = f32::make_renderer(program, options));
        };
        const auto choice = choose(*session, open_float, options, Clock::now(), going_on);
        options.settings = choice->expected.settings;
        if (choice->in_float) {
            options.precision = Precision::f32;
            session = std::move(in_float);
        }
    }
    (void)session->run(options, nullptr, going_on);
    return {.image = {}, .seconds = cpu_seconds() - start};
}

void measure(const std::filesystem::path& scene, double tolerance) {
    Options options{};
    options.scene = scene.string();
    options.size = size;
    Options with_tolerance = options;
    with_tolerance.tolerance = tolerance;
    const auto session = f64::make_renderer(program, options);
    CountedTrials trials(*session);
    const auto choice = choose(trials, {}, with_tolerance, Clock::now(), going_on);
    const RenderSettings& settings = choice->expected.settings;
    const Subject subject(scene, tolerance);
    const Outcome picture = subject.outcome(settings);
    const auto [fastest, rays] = subject.fastest(settings, few_pixels);
    const auto [as_accurate, its_rays] = subject.fastest(settings, picture.beyond);
    const double same =
        time_ratio([&] { return Drawing{.seconds = subject.outcome(settings).seconds}; },
                   [&] { return Drawing{.seconds = subject.outcome(as_accurate).seconds}; })
            .time;
    options.settings = fastest;
    const TimeRatio time =
        time_ratio([&] { return whole_time(with_tolerance); }, [&] { return whole_time(options); });
    std::printf(
        "%s,%d,%g,%d,%g,%d,%.5f,%.5f,%.5f,%.3f,%.3f,%.3f,%.3f,%.2f,%.2f,%.2f,%d,%g,%d,%d,%g,%d,%."
        "2f\n",
        scene.stem().c_str(), size.width, tolerance, settings.pixel_samples, settings.pixel_error,
        settings.shadow_samples, picture.beyond, choice->expected.at_most, subject.exact_off(),
        picture.worst_tile, trials.rays() / rays, picture.rays / rays,
        (trials.rays() + picture.rays) / rays, time.time, time.least, time.greatest,
        fastest.pixel_samples, fastest.pixel_error, fastest.shadow_samples,
        as_accurate.pixel_samples, as_accurate.pixel_error, as_accurate.shadow_samples, same);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    const double tolerance = count > 1 ? std::atof(arguments[1]) : 2;
    const std::string only = count > 2 ? arguments[2] : "all";
    if (count > 3) size.width = std::atoi(arguments[3]);
    size.height = size.width * 3 / 4;
    std::puts(
        "scene,width,tolerance,samples,pixel_error,shadow_samples,beyond,at_most,exact_off,"
        "worst_tile,trials,picture,rays,time,least,greatest,fastest_samples,fastest_pixel_error,"
        "fastest_shadow_samples,same_samples,same_pixel_error,same_shadow_samples,same");
    if (std::filesystem::is_regular_file(only)) return measure(only, tolerance), 0;
    for (const auto& scene : scenes_for_choices())
        if (only == "all" || scene.stem() == only) measure(scene, tolerance);
}
