#include "common/tuning/choose_pixels.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/choose_samples.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/pixel_study.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace rt {

namespace {

/// No error of a pixel is larger: with it, one ray through each pixel is enough.
constexpr double largest_pixel_error = 255;

/// The factor from one error that is tried to the next. Every fourth needs twice as many rays.
const double error_step = std::pow(2, 0.25);

/// The settings with the rays to lights that are chosen with those through pixels: four from the
/// only ray through a pixel, one from each of several. More from each cost up to three times as
/// much, and seldom save anything: the rays through a pixel share their errors. None stops early:
/// rays that stop once a few agree would make the mean of a pixel wrong, however many go through
/// it.
RenderSettings with_few_shadow_rays(const TrialRunner& runner, const Trials& trials,
                                    const RenderSettings& settings) {
    const bool chosen = trials.traits().sized_lights && !runner.aim().given.shadow_samples;
    return chosen ? with_rays(settings, 4) : settings;
}

RenderSettings with_pixel_samples(RenderSettings settings, int count) {
    settings.pixel_samples = count;
    settings.pixel_error = 0;
    return settings;
}

RenderSettings with_pixel_error(RenderSettings settings, double error) {
    settings.pixel_samples = right_pixel_samples;
    settings.pixel_error = two_digits(error);
    return settings;
}

/// Trial pixels with their right colors, for the choice with a time budget.
class PixelTrials {
public:
    /// The references have an error of an eighth of `error`.
    PixelTrials(TrialRunner& runner, const Trials& trials, const RenderSettings& settings,
                double error)
        : runner_(runner), trials_(trials), reference_(settings) {
        const bool sized_lights = trials.traits().sized_lights;
        if (sized_lights) reference_ = with_rays(reference_, 1);
        reference_.pixel_samples = right_pixel_samples;
        reference_.pixel_error = error / 8;
        // As many rays that agree as in reference_settings: fewer may miss a part of a light.
        at_least_ =
            sized_lights ? int(std::bit_floor(unsigned(std::clamp(200 / error, 32., 256.)))) : 32;
    }

    /// Adds trial pixels.
    void add(std::span<const Pixel> pixels) {
        const TrialSample right = runner_.render_pixels(trials_, reference_, pixels, 1, at_least_);
        pixels_.insert(pixels_.end(), pixels.begin(), pixels.end());
        right_.shades.insert(right_.shades.end(), right.shades.begin(), right.shades.end());
    }

    /// Measures settings. Their error is that which one pixel in a hundred exceeds.
    Trial measured(const RenderSettings& settings) {
        const TrialSample sample = runner_.render_pixels(trials_, settings, pixels_, ++round_);
        return {.settings = settings,
                .seconds = runner_.picture_seconds(sample.seconds),
                .rays = sample.rays,
                .error = error_but_for_share(few_pixels, distances(sample, right_))};
    }

private:
    TrialRunner& runner_;
    const Trials& trials_;
    RenderSettings reference_;
    int at_least_ = 0;
    int round_ = 1;
    std::vector<Pixel> pixels_;
    TrialSample right_;
};

/// Settings, with the expected cost and error of a picture.
struct Candidate {
    RenderSettings settings;
    PixelStudy::Outcome outcome;
};

/// The search for the cheapest settings that keep the tolerance.
class PixelSearch {
public:
    PixelSearch(TrialRunner& runner, Trials& trials, const RenderSettings& settings)
        : runner_(runner),
          allowed_(*runner.aim().tolerance),
          settings_(settings),
          study_(runner, trials, settings, allowed_) {}

    /// The least accurate right colors are compared first, since most of the cost is theirs. With
    /// more accurate ones, rays beside edges may keep the tolerance where before only rays through
    /// every pixel seemed to.
    [[nodiscard]] Trial best() {
        Candidate best{.settings = with_pixel_samples(settings_, right_pixel_samples)};
        for (double right_error = allowed_; right_error > allowed_ / 16; right_error /= 2) {
            best = best_with(right_error).value_or(best);
            if (best.settings.pixel_error > 0 || best.settings.pixel_samples == 1) break;
        }
        best.outcome = study_.outcome(best.settings);
        return trial(best);
    }

private:
    /// Traces trial pixels until more of them would take more rays than they could save.
    [[nodiscard]] std::optional<Candidate> best_with(double right_error) {
        study_.begin(right_error);
        while (true) {
            const std::vector<Candidate> all = candidates(right_error);
            const auto best = std::ranges::find_if(all, [&](const Candidate& candidate) {
                return candidate.outcome.at_most() <= few_pixels &&
                       study_.tiles_keep(candidate.settings, 2 * allowed_);
            });
            const auto growth =
                best_growth(std::span(all.begin(), best),
                            best == all.end() ? std::nullopt : std::optional(best->outcome.rays));
            if (growth)
                study_.grow(*growth);
            else
                return best == all.end() ? std::nullopt : std::optional(*best);
        }
    }

    /// The kind of trial pixels of which more are worth their rays, since one of these settings may
    /// then be certain to keep the tolerance. `rays` are those of the cheapest that does, if any.
    [[nodiscard]] std::optional<std::size_t> best_growth(std::span<const Candidate> cheaper,
                                                         std::optional<double> rays) const {
        constexpr double chance = 0.5;  // what is estimated of them may be wrong
        std::optional<std::size_t> kind;
        double least = 0;
        for (const auto& [settings, outcome] : cheaper) {
            const auto growth = study_.growth(outcome, few_pixels);
            if (!growth) continue;
            const double cost = growth->rays + chance * (outcome.rays - rays.value_or(1e15));
            if (cost < least) {
                least = cost;
                kind = growth->kind;
            }
        }
        return kind;
    }

    /// All settings that can be compared with right colors of that error, the cheapest first.
    [[nodiscard]] std::vector<Candidate> candidates(double right_error) const {
        std::vector<Candidate> all;
        const auto add = [&](const RenderSettings& settings) {
            all.push_back({.settings = settings, .outcome = study_.outcome(settings)});
        };
        add(with_pixel_samples(settings_, 1));
        for (double error = right_error * error_step * error_step;
             error < std::min(64 * allowed_, largest_pixel_error); error *= error_step)
            add(with_pixel_error(settings_, error));
        if (right_error < allowed_)
            for (int count = 4; count < right_pixel_samples; count *= 2)
                add(with_pixel_samples(settings_, count));
        std::ranges::stable_sort(all, {},
                                 [](const Candidate& candidate) { return candidate.outcome.rays; });
        return all;
    }

    [[nodiscard]] Trial trial(const Candidate& candidate) const {
        const double more = candidate.outcome.rays / runner_.pixels();
        const TrialCenters& centers = study_.centers();
        return {
            .settings = candidate.settings,
            .seconds = runner_.picture_seconds(centers.seconds + more * study_.seconds_of_a_ray()),
            .rays = centers.rays + more,
            .error = allowed_};
    }

    TrialRunner& runner_;
    double allowed_;
    RenderSettings settings_;
    PixelStudy study_;
};

}  // namespace

Trial keep_tolerance_of_pixels(TrialRunner& runner, Trials& trials,
                               const RenderSettings& settings) {
    return PixelSearch(runner, trials, with_few_shadow_rays(runner, trials, settings)).best();
}

QualityLadder measure_pixel_ladder(TrialRunner& runner, const Trials& trials,
                                   const RenderSettings& given) {
    constexpr std::size_t fewest = 64;
    constexpr std::size_t most = 1024;
    constexpr double finest = 0.5;
    const double time = *runner.aim().time;
    const RenderSettings settings = with_few_shadow_rays(runner, trials, given);
    PixelTrials known(runner, trials, settings, 1);
    const std::vector<Pixel> pixels = in_spread_order(runner.spread().pixels());
    for (std::size_t i = 0; i < std::min(pixels.size(), most); i += fewest) {
        known.add(std::span(pixels).subspan(i, std::min(fewest, pixels.size() - i)));
        if (runner.seconds_since_start() > time / 20) break;
    }
    std::vector<RenderSettings> adaptive;
    for (double error = largest_pixel_error; error >= finest;
         error = std::min(error, 32 * std::sqrt(2)) / std::sqrt(2))
        adaptive.push_back(with_pixel_error(settings, error));
    QualityLadder ladder;
    for (std::size_t i = 0; i < adaptive.size(); ++i) {
        ladder.add(known.measured(adaptive[i]));
        if (ladder.top().seconds > time) return ladder;
        if (!runner.no_time_left()) continue;
        ladder.extend({adaptive.begin() + std::ptrdiff_t(i) + 1, adaptive.end()}, time);
        return ladder;
    }
    // There is time for more than adaptive sampling can use: it does not find every edge.
    QualityLadder whole;
    for (int count = 64; count <= right_pixel_samples; count *= 2) {
        whole.add(known.measured(with_pixel_samples(settings, count)));
        if (whole.top().seconds > time || runner.no_time_left()) break;
    }
    const Trial fits = whole.within_time(time);
    return fits.seconds <= time && fits.error < ladder.top().error ? whole : ladder;
}

std::string pixels_in_words(const RenderSettings& settings) {
    if (settings.pixel_error > 0 && settings.pixel_error < largest_pixel_error)
        return "more than one beside edges, until the estimated error is below " +
               levels(settings.pixel_error);
    return settings.pixel_samples == 1 || settings.pixel_error > 0
               ? "1, through the center"
               : std::to_string(settings.pixel_samples);
}

}  // namespace rt
