#include "common/tuning/render_trials.hpp"

#include "common/render/pixel_samples.hpp"
#include "common/system/countdown.hpp"
#include "common/system/parallel_for.hpp"
#include "common/tuning/pixel_errors.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <queue>
#include <set>
#include <utility>

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
        PixelHistory history;
        double seen = 0;
        if (request_.scouts > 0) {
            const auto before = context_.rays;
            begin(pixel, adaptive_settings(settings_), request_.round + 1);
            PixelSamples scouts(scene_, finer_rays_, pixel, context_);
            scouts.trace_to(request_.scouts);
            history.ray_rays = double(context_.rays - before) / request_.scouts;
            if (!is_found(pixel, scouts.mean())) return history;
            seen = scouts.range(settings_.gamma);
        }
        ScoutGroups groups;
        history.runs[0] = run(pixel, request_.round, settings_.pixel_samples, seen, groups);
        const PixelStep& last = history.runs[0].back();
        history.ray_rays = last.rays / last.count;
        history.runs[1] = run(pixel, request_.round + 2, last.count, 255, groups);
        history.stands_for = (groups.all + 1.0) / (groups.found + 1.0);
        if (request_.centers != nullptr) history.followed = followed(pixel, history.mean());
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

    /// The steps of the rays with the random numbers of this round. Something that was seen with
    /// this range counts as a part of every step's error.
    [[nodiscard]] std::vector<PixelStep> run(Pixel pixel, int round, int most, double seen,
                                             ScoutGroups& groups) {
        begin(pixel, adaptive_settings(settings_), round);
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        const auto before = context_.rays;
        const int scouts = request_.scouts;
        int grouped = scouts;
        Color sum{0};  // of the colors of the rays in groups
        std::vector<PixelStep> steps;
        for (int count = PixelHistory::fewest; count <= most; count = PixelHistory::next(count)) {
            for (; scouts > 0 && grouped <= count; grouped += scouts) {
                samples.trace_to(grouped);
                const Color all = Real(grouped) * samples.mean();
                groups.found += is_found(pixel, (all - std::exchange(sum, all)) / Real(scouts));
                ++groups.all;
            }
            samples.trace_to(count);
            steps.push_back({.count = count,
                             .mean = shade(samples.mean(), settings_.gamma),
                             .error = samples.error(settings_.gamma),
                             .rays = double(context_.rays - before)});
            seen = std::max(seen, samples.range(settings_.gamma));
            const double error = std::max(steps.back().error, seen / count);
            if (count >= request_.at_least && error <= settings_.pixel_error) break;
        }
        return steps;
    }

    /// The largest difference (refinement.hpp) with which an edge is followed to the pixel. Of all
    /// ways to it from pixel to pixel, that is the one on which the smallest step is largest: the
    /// step from a pixel is the range of its rays, and the first is its contrast.
    [[nodiscard]] double followed(Pixel pixel, const DisplayColor& mean) {
        const DisplayColor center = display_color((*request_.centers)[pixel]);
        double most = contrast_around(*request_.centers, pixel, 1);
        const double enough = 64 * request_.visible;
        if (most >= enough || distance(center, mean) <= 4 * request_.visible) return most;
        constexpr std::size_t farthest = 80;  // pixels
        std::set<std::pair<int, int>> known{{pixel.row, pixel.column}};
        std::priority_queue<Step> steps;
        Step step{.least = enough, .pixel = pixel};
        do {
            for (const Pixel next : neighbors(step.pixel))
                if (known.size() < farthest && known.emplace(next.row, next.column).second)
                    steps.push({std::min(step.least, range(next)), next});
            if (steps.empty()) break;
            step = steps.top();
            steps.pop();
            const double contrast = contrast_around(*request_.centers, step.pixel, 0);
            most = std::max(most, std::min(step.least, contrast));
        } while (step.least > most);
        return most;
    }

    struct Step {
        double least = 0;
        Pixel pixel;
        friend bool operator<(const Step& a, const Step& b) { return a.least < b.least; }
    };

    [[nodiscard]] std::vector<Pixel> neighbors(Pixel pixel) const {
        std::vector<Pixel> all;
        for (int row = std::max(pixel.row - 1, 0);
             row <= std::min(pixel.row + 1, scene_.resolution.height - 1); ++row)
            for (int column = std::max(pixel.column - 1, 0);
                 column <= std::min(pixel.column + 1, scene_.resolution.width - 1); ++column)
                all.push_back({.row = row, .column = column});
        return all;
    }

    /// The largest difference with which the picture goes on to the neighbors of a pixel: that of
    /// its first rays, of which a smaller difference takes more.
    [[nodiscard]] double range(Pixel pixel) {
        begin(pixel, adaptive_settings(settings_), request_.round);
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        double error = 4;
        do {
            samples.trace_to(first_pixel_samples(error));
            if (samples.range(settings_.gamma) > 2 * error)
                return error < 4 ? std::min(samples.range(settings_.gamma), 4 * error)
                                 : samples.range(settings_.gamma);
            error /= 2;
        } while (error > settings_.pixel_error);
        return 0;
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
