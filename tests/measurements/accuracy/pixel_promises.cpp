// Measures the promise of --tolerance about the rays through pixels, and its cost. The picture of
// each scene with the chosen settings is compared with one of 1,024 rays through each pixel. The
// rays of the trials and of the picture are given in units of those of the cheapest settings found
// that keep the same promise. The arguments are the tolerance, one scene (or "all"), and the width.
#include "common/program/load_meshes.hpp"
#include "common/program/renderer.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/trial_pixels.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>

using namespace rt;

namespace {

Resolution size{.width = 160, .height = 120};
const std::atomic<bool> going_on = false;

/// The scene of the program, with the rays of trials counted.
class CountedTrials : public Trials {
public:
    explicit CountedTrials(Trials& scene) : scene_(scene) {}

    [[nodiscard]] Resolution resolution() const override { return scene_.resolution(); }
    [[nodiscard]] SceneTraits traits() const override { return scene_.traits(); }
    void build_acceleration(std::size_t hierarchy_from) override {
        scene_.build_acceleration(hierarchy_from);
    }
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

    [[nodiscard]] bool keeps(double tolerance) const {
        return beyond <= 0.01 && worst_tile <= 2 * tolerance;
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
        if (sized_lights_) right = with_rays(right, 1);
        exact_ = render(scene_, {.settings = right}).value().image;
    }

    [[nodiscard]] Outcome outcome(const RenderSettings& settings) const {
        const Rendering rendering = render(scene_, {.settings = settings}).value();
        Outcome outcome{.rays = double(rendering.rays)};
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

    /// The fewest rays with which a picture keeps the promise: of one ray for each pixel, numbers
    /// of rays, and errors in steps of a tenth, with 4, 16 or 64 rays to a light.
    [[nodiscard]] std::pair<double, RenderSettings> cheapest(RenderSettings settings) const {
        std::pair found{std::numeric_limits<double>::infinity(), settings};
        const auto try_one = [&](const RenderSettings& tried) {
            const Outcome it = outcome(tried);
            if (it.keeps(tolerance_) && it.rays < found.first) found = {it.rays, tried};
            return it.rays <= 1.1 * found.first;
        };
        settings.shadow_error = settings.shadow_agree = 0;
        for (const int shadow_samples : {4, 16, 64}) {
            if (!sized_lights_ && shadow_samples > 4) break;
            settings.shadow_samples = shadow_samples;
            settings.pixel_samples = 1024;
            for (settings.pixel_error = 16 * tolerance_; settings.pixel_error > tolerance_ / 4;
                 settings.pixel_error /= 1.1)
                if (!try_one(settings)) break;
            settings.pixel_error = 0;
            for (settings.pixel_samples = 1; settings.pixel_samples <= 1024;
                 settings.pixel_samples *= 2)
                if (!try_one(settings)) break;
        }
        return found;
    }

private:
    double tolerance_;
    Scene scene_;
    bool sized_lights_ = false;
    Image exact_;
};

void measure(const std::filesystem::path& scene, double tolerance) {
    Options options{};
    options.scene = scene.string();
    options.size = size;
    options.tolerance = tolerance;
    const auto session = f64::make_renderer({.stage = 13, .root = RAYSTEPS_ROOT}, options);
    CountedTrials trials(*session);
    const auto choice = choose(trials, {}, options, Clock::now(), going_on);
    const RenderSettings& settings = choice->expected.settings;
    const Subject subject(scene, tolerance);
    const Outcome picture = subject.outcome(settings);
    const auto [fewest, least] = subject.cheapest(settings);
    const double one = subject.outcome({.shadow_samples = settings.shadow_samples}).rays;
    std::printf("%s,%d,%g,%d,%g,%d,%.5f,%.3f,%.3f,%.3f,%.3f,%.2f,%d,%g,%d\n", scene.stem().c_str(),
                size.width, tolerance, settings.pixel_samples, settings.pixel_error,
                settings.shadow_samples, picture.beyond, picture.worst_tile, picture.rays / one,
                trials.rays() / fewest, picture.rays / fewest,
                (trials.rays() + picture.rays) / fewest, least.pixel_samples, least.pixel_error,
                least.shadow_samples);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    const double tolerance = count > 1 ? std::atof(arguments[1]) : 2;
    const std::string only = count > 2 ? arguments[2] : "all";
    if (count > 3) size.width = std::atoi(arguments[3]);
    size.height = size.width * 3 / 4;
    std::puts(
        "scene,width,tolerance,samples,pixel_error,shadow_samples,beyond,worst_tile,one_ray,"
        "trials,picture,cost,cheapest_samples,cheapest_pixel_error,cheapest_shadow_samples");
    for (const auto& scene : scenes_for_choices())
        if (only == "all" || scene.stem() == only) measure(scene, tolerance);
}
