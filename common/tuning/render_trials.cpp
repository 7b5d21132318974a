#include "common/tuning/render_trials.hpp"

#include "common/render/pixel_samples.hpp"
#include "common/system/cpu_seconds.hpp"
#include "common/system/parallel_for.hpp"
#include "common/tuning/pixel_errors.hpp"

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
        begin(pixel, several ? shared_settings(settings_) : settings_, request_.round);
        return several ? mean_color(scene_, finer_rays_, pixel, context_)
                       : trace(scene_, pixel_ray_(pixel), context_);
    }

    [[nodiscard]] PixelHistory history(Pixel pixel) {
        const Gamma gamma = settings_.gamma;
        PixelHistory history;
        double seen = 0;
        if (request_.scouts > 0) {
            const auto before = context_.rays;
            begin(pixel, adaptive_settings(settings_), request_.round + 1);
            PixelSamples scouts(scene_, finer_rays_, pixel, context_);
            scouts.trace_to(request_.scouts);
            history.ray_rays = double(context_.rays - before) / request_.scouts;
            if (!is_found(pixel, scouts.mean())) return history;
            seen = scouts.range(gamma);
        }
        begin(pixel, adaptive_settings(settings_), request_.round);
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        ScoutGroups groups;
        const auto before = context_.rays;
        for (int count = PixelHistory::fewest; count <= settings_.pixel_samples;
             count = PixelHistory::next(count)) {
            trace_to(count, pixel, samples, groups);
            history.steps.push_back({.count = count,
                                     .mean = shade(samples.mean(), gamma),
                                     .error = samples.error(gamma),
                                     .rays = double(context_.rays - before)});
            seen = std::max(seen, samples.range(gamma));
            const double error = std::max(history.steps.back().error, seen / count);
            if (count >= request_.at_least && error <= settings_.pixel_error) break;
        }
        history.ray_rays = history.steps.back().rays / history.steps.back().count;
        begin(pixel, adaptive_settings(settings_), request_.round + 2);
        PixelSamples others(scene_, finer_rays_, pixel, context_);
        others.trace_to(history.steps.back().count);
        history.other_mean = shade(others.mean(), gamma);
        history.stands_for = (groups.all + 1.0) / (groups.found + 1.0);
        return history;
    }

    /// The rays to area lights of the last pixel.
    [[nodiscard]] int light_rays() const { return int(context_.sized_light_rays); }
    [[nodiscard]] std::int64_t rays() const { return context_.rays; }

private:
    /// The rays of a history in groups of as many as there are scouts.
    struct ScoutGroups {
        int all = 0;
        int found = 0;  ///< the groups that would have found something
        Color sum{0};   ///< of the colors of their rays
    };

    void begin(Pixel pixel, const RenderSettings& settings, int round) {
        context_.settings = settings;
        context_.pixel = seed_pixel(pixel, scene_.resolution, round);
    }

    /// Returns whether the mean color of scouts differs from that of the center.
    [[nodiscard]] bool is_found(Pixel pixel, const Color& mean) const {
        return distance(shade(mean, settings_.gamma), display_color((*request_.centers)[pixel])) >
               request_.visible;
    }

    void trace_to(int count, Pixel pixel, PixelSamples& samples, ScoutGroups& groups) {
        const int scouts = request_.scouts;
        for (int end = (groups.all + 1) * scouts; scouts > 0 && end <= count; end += scouts) {
            samples.trace_to(end);
            const Color sum = Real(end) * samples.mean();
            groups.found += is_found(pixel, (sum - groups.sum) / Real(scouts));
            groups.sum = sum;
            ++groups.all;
        }
        samples.trace_to(count);
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
