// The promise of --tolerance, in many runs of each scene that has a light with a size: their number
// is the first argument, and each has its own rays and number of threads. Prints how often every
// part of the promise is kept, compared with the picture with all rays, and how many rays the
// picture and its trials take, in units of the fewest rays of other settings that keep it too.
#include "common/program/renderer.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/promise.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>

using namespace rt;

namespace {

constexpr double tolerances[] = {1, 4};
constexpr Resolution sizes[] = {{320, 240}, {640, 480}};
const std::atomic<bool> going_on = false;

/// Rounds of rays: more than the trials of a run have.
constexpr int rounds = 1000;
constexpr int truth_round = 1;

/// The scene with the rays of one run, which are counted.
class Run : public Trials {
public:
    Run(Trials& scene, int run) : scene_(scene), first_round_((run + 1) * rounds) {}

    [[nodiscard]] Resolution resolution() const override { return scene_.resolution(); }
    [[nodiscard]] SceneTraits traits() const override { return scene_.traits(); }
    [[nodiscard]] double smallest_gap() const override { return scene_.smallest_gap(); }
    void build_acceleration(std::size_t hierarchy_from) override {
        scene_.build_acceleration(hierarchy_from);
    }

    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        TrialRequest own = request;
        own.round += first_round_;
        TrialSample sample = scene_.render_pixels(settings, own);
        rays_ += sample.rays * double(request.pixels.size());
        return sample;
    }

    // Not for a given number of rays through a pixel:
    [[nodiscard]] TrialHistories trace_histories(const RenderSettings& settings,
                                                 const TrialRequest& request) const override {
        return scene_.trace_histories(settings, request);
    }
    [[nodiscard]] TrialCenters render_centers(const RenderSettings& settings,
                                              const TrialRequest& request) override {
        return scene_.render_centers(settings, request);
    }

    [[nodiscard]] double rays() const { return rays_; }

private:
    Trials& scene_;
    int first_round_;
    mutable double rays_ = 0;
};

std::vector<Pixel> all_pixels(Resolution size) {
    std::vector<Pixel> pixels;
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column) pixels.push_back(pixel);
    return pixels;
}

/// Which share of them is off by more than the tolerance, of what counts.
struct Beyond {
    double all = 0;
    double in_penumbrae = 0;
    double in_worst_tile = 0;

    [[nodiscard]] bool as_promised() const {
        return all <= few_pixels && in_penumbrae <= few_in_penumbrae &&
               in_worst_tile <= few_in_a_tile;
    }
};

/// A scene at a size, and what is right.
class Subject {
public:
    Subject(const std::filesystem::path& scene, Resolution size) {
        options_.scene = scene.string();
        options_.size = size;
        options_.given.pixel_samples = true;  // one: the error is that of lights
        in_double_ = f64::make_renderer(program, options_);
        pixels_ = all_pixels(size);
        const RenderSettings settings = to_error(RenderSettings(), 1.0 / 8, 0);
        right_ = render_pixels(*in_double_, settings, truth_round);
        one_ray_ = render_pixels(*in_double_, with_rays(RenderSettings(), 1), truth_round + 1);
    }

    /// Of 10 numbers of rays, and of ladders of errors, one for each number of rays that agree.
    [[nodiscard]] double fewest_rays(double tolerance) const {
        double fewest = std::numeric_limits<double>::infinity();
        for (const int samples : {1, 2, 4, 8, 16, 32, 64, 128, 256, 512})
            if (try_one(with_rays(RenderSettings(), samples), tolerance, fewest)) break;
        for (int agree = 4; agree <= 256; agree *= 2)
            for (double error = 1.4 * tolerance; error > tolerance / 4; error /= std::pow(2, 0.25))
                if (try_one(to_error(RenderSettings(), error, agree), tolerance, fewest)) break;
        return fewest;
    }

    struct Outcome {
        Beyond beyond;
        double picture = 0;  ///< rays
        double trials = 0;
        RenderSettings settings;
    };

    [[nodiscard]] Outcome outcome(double tolerance, int number) {
        constexpr int most_threads = 4;
        Options options = options_;
        options.tolerance = tolerance;
        options.threads = 1 + number % most_threads;
        Run run(*in_double_, number);
        std::unique_ptr<Renderer> in_float;
        std::unique_ptr<Run> float_run;
        const auto open_float = [&]() -> Trials& {
            in_float = f32::make_renderer(program, options);
            float_run = std::make_unique<Run>(*in_float, number);
            return *float_run;
        };
        const AutoSettings choice =
            choose(run, open_float, options, Clock::now(), going_on).value();
        const double trials = run.rays() + (float_run ? float_run->rays() : 0);
        const Trials& chosen = choice.in_float ? *float_run : run;
        const TrialSample picture = render_pixels(chosen, choice.expected.settings, 0);
        return {.beyond = beyond(picture, tolerance),
                .picture = picture.rays * double(pixels_.size()),
                .trials = trials,
                .settings = choice.expected.settings};
    }

private:
    inline static const Program program{.stage = 13, .root = RAYSTEPS_ROOT};

    [[nodiscard]] TrialSample render_pixels(const Trials& trials, const RenderSettings& settings,
                                            int round) const {
        return trials.render_pixels(settings, {.pixels = pixels_, .round = round, .threads = 2});
    }

    /// Returns whether finer looks take more than the fewest rays that keep the tolerance. Judged
    /// by two pictures: one alone may be lucky.
    [[nodiscard]] bool try_one(const RenderSettings& settings, double tolerance,
                               double& fewest) const {
        double rays = 0;
        for (const int round : {truth_round + 2, truth_round + 3}) {
            const TrialSample picture = render_pixels(*in_double_, settings, round);
            rays = picture.rays * double(pixels_.size());
            if (rays >= fewest) return true;
            if (!beyond(picture, tolerance).as_promised()) return false;
        }
        fewest = rays;
        return true;
    }

    [[nodiscard]] Beyond beyond(const TrialSample& picture, double tolerance) const {
        std::map<int, std::pair<int, int>> tiles;  // pixels beyond, and all
        double all = 0;
        double in_penumbrae = 0;
        double penumbrae = 0;
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            const bool is_off = distance(picture.shades[i], right_.shades[i]) > tolerance;
            const bool in_one = distance(one_ray_.shades[i], right_.shades[i]) > tolerance;
            auto& [off, pixels] = tiles[tile_of(pixels_[i], *options_.size)];
            off += is_off;
            ++pixels;
            all += is_off;
            penumbrae += in_one;
            in_penumbrae += is_off && in_one;
        }
        Beyond result{.all = all / double(pixels_.size()),
                      .in_penumbrae = in_penumbrae / std::max(penumbrae, 1.)};
        for (const auto& [tile, counts] : tiles)
            result.in_worst_tile =
                std::max(result.in_worst_tile, double(counts.first) / counts.second);
        return result;
    }

    Options options_{};
    std::unique_ptr<Renderer> in_double_;
    std::vector<Pixel> pixels_;
    TrialSample right_;
    TrialSample one_ray_;
};

void measure(const std::filesystem::path& scene, Resolution size, int runs, bool tell_all) {
    Subject subject(scene, size);
    for (const double tolerance : tolerances) {
        const double fewest = subject.fewest_rays(tolerance);
        int kept = 0;
        Beyond worst;
        double trials = 0;
        double picture = 0;
        double most = 0;
        for (int run = 0; run < runs; ++run) {
            const auto outcome = subject.outcome(tolerance, run);
            kept += outcome.beyond.as_promised();
            worst = {.all = std::max(worst.all, outcome.beyond.all),
                     .in_penumbrae = std::max(worst.in_penumbrae, outcome.beyond.in_penumbrae),
                     .in_worst_tile = std::max(worst.in_worst_tile, outcome.beyond.in_worst_tile)};
            trials += outcome.trials / fewest / runs;
            picture += outcome.picture / fewest / runs;
            most = std::max(most, (outcome.trials + outcome.picture) / fewest);
            if (tell_all)
                std::fprintf(stderr, "%s e%.2g a%d n%d: %.3f + %.3f, off %.4f %.3f %.3f%s\n",
                             scene.stem().c_str(), outcome.settings.shadow_error,
                             outcome.settings.shadow_agree, outcome.settings.shadow_samples,
                             outcome.trials / fewest, outcome.picture / fewest, outcome.beyond.all,
                             outcome.beyond.in_penumbrae, outcome.beyond.in_worst_tile,
                             outcome.beyond.as_promised() ? "" : " BROKEN");
        }
        std::printf("%s,%d,%g,%d,%d,%.4f,%.4f,%.4f,%.3f,%.3f,%.3f\n", scene.stem().c_str(),
                    size.width, tolerance, runs, kept, worst.all, worst.in_penumbrae,
                    worst.in_worst_tile, trials, picture, most);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const int runs = count > 1 ? std::atoi(arguments[1]) : 100;
    const std::string only = count > 2 ? arguments[2] : "";
    const int width = count > 3 ? std::atoi(arguments[3]) : 0;
    std::puts(
        "scene,width,tolerance,runs,kept,off,off_in_penumbrae,off_in_worst_tile,trials,picture,"
        "most");
    for (const auto& scene : scenes_for_choices()) {
        if (!only.empty() && scene.stem() != only) continue;
        Options options{};
        options.scene = scene.string();
        const auto session =
            f64::make_renderer(Program{.stage = 13, .root = RAYSTEPS_ROOT}, options);
        if (!session->traits().sized_lights) continue;
        for (const Resolution size : sizes)
            if (width == 0 || size.width == width) measure(scene, size, runs, count > 4);
    }
}
