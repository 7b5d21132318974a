#include "common/tuning/render_trials.hpp"

#include "common/render/pixel_samples.hpp"
#include "common/system/cpu_seconds.hpp"
#include "common/system/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace rt {

namespace {

/// The pixel that seeds the random samples; outside the picture from the second round on, so that
/// the seeds differ.
Pixel seed_pixel(Pixel pixel, Resolution size, int round) {
    return {.row = pixel.row + round * size.height, .column = pixel.column};
}

DisplayColor shade(const Color& color, Gamma gamma) {
    const auto shown = [gamma](Real value) { return 255 * encoded(double(value), gamma); };
    return {shown(color.r), shown(color.g), shown(color.b)};
}

/// The colors of single pixels of a picture.
class PixelTrial {
public:
    PixelTrial(const Scene& scene, const RenderSettings& settings, const TrialRequest& request)
        : scene_(scene),
          settings_(settings),
          request_(request),
          pixel_ray_(pixel_rays(scene.cameras.front(), scene.resolution)),
          finer_rays_(scene.cameras.front(), scene.resolution) {}

    [[nodiscard]] Color color(Pixel pixel) {
        context_.sized_light_rays = 0;
        const bool several = settings_.pixel_samples > 1;
        begin(pixel, several ? shared_settings(settings_) : settings_);
        return several ? mean_color(scene_, finer_rays_, pixel, context_)
                       : trace(scene_, pixel_ray_(pixel), context_);
    }

    [[nodiscard]] PixelHistory history(Pixel pixel) {
        begin(pixel, adaptive_settings(settings_));
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        const auto before = context_.rays;
        PixelHistory history;
        for (int count = PixelHistory::fewest; count <= settings_.pixel_samples;
             count = PixelHistory::next(count)) {
            samples.trace_to(count);
            history.steps.push_back({.count = count,
                                     .mean = shade(samples.mean(), settings_.gamma),
                                     .error = samples.error(settings_.gamma),
                                     .rays = double(context_.rays - before)});
            if (count >= request_.at_least && history.steps.back().error <= settings_.pixel_error)
                break;
        }
        history.range = samples.range(settings_.gamma);
        return history;
    }

    /// The rays to area lights of the last pixel.
    [[nodiscard]] int light_rays() const { return int(context_.sized_light_rays); }
    [[nodiscard]] std::int64_t rays() const { return context_.rays; }

private:
    void begin(Pixel pixel, const RenderSettings& settings) {
        context_.settings = settings;
        context_.pixel = seed_pixel(pixel, scene_.resolution, request_.round);
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    const TrialRequest& request_;
    PixelRays pixel_ray_;
    FinerRays finer_rays_;
    Context context_{};
};

/// The total cost of the pixels of a trial.
struct Cost {
    double rays = 0;
    double seconds = 0;
};

/// Calls draw_one(trial, index) for each pixel of the request.
template <class DrawOne>
Cost draw(const Scene& scene, const RenderSettings& settings, const TrialRequest& request,
          DrawOne draw_one) {
    constexpr std::size_t together = 16;  // pixels in one unit of a thread's work
    const std::size_t count = request.pixels.size();
    std::atomic<std::int64_t> rays = 0;
    const double start = cpu_seconds();
    const auto draw_part = [&](std::size_t part) {
        PixelTrial trial(scene, settings, request);
        const std::size_t end = std::min((part + 1) * together, count);
        for (std::size_t i = part * together; i < end; ++i) draw_one(trial, i);
        rays += trial.rays();
    };
    parallel_for(request.threads, (count + together - 1) / together, request.stop, draw_part);
    return {.rays = double(rays), .seconds = cpu_seconds() - start};
}

}  // namespace

TrialSample render_pixels(const Scene& scene, const RenderSettings& settings,
                          const TrialRequest& request) {
    const std::size_t count = request.pixels.size();
    TrialSample sample{.shades = std::vector<DisplayColor>(count),
                       .light_rays = std::vector<int>(count)};
    const Cost cost = draw(scene, settings, request, [&](PixelTrial& trial, std::size_t i) {
        sample.shades[i] = shade(trial.color(request.pixels[i]), settings.gamma);
        sample.light_rays[i] = trial.light_rays();
    });
    if (count == 0) return sample;
    sample.rays = cost.rays / double(count);
    sample.seconds = cost.seconds / double(count);
    return sample;
}

TrialHistories trace_histories(const Scene& scene, const RenderSettings& settings,
                               const TrialRequest& request) {
    TrialHistories histories{.pixels = std::vector<PixelHistory>(request.pixels.size())};
    const Cost cost = draw(scene, settings, request, [&](PixelTrial& trial, std::size_t i) {
        histories.pixels[i] = trial.history(request.pixels[i]);
    });
    histories.rays = cost.rays;
    histories.seconds = cost.seconds;
    return histories;
}

}  // namespace rt
