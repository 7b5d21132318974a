#include "common/tuning/choices.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace rt {

namespace {

constexpr double least_part = 0.35;          ///< of the tolerance
constexpr std::size_t enough_pixels = 1000;  ///< pixels

/// The number of agreeing rays with which the search starts.
int usual_agree(double allowed) {
    return int(std::bit_floor(unsigned(std::clamp(32 / std::sqrt(allowed), 4., 1024.))));
}

/// The settings that are tried, the cheapest first. A smaller error than the last changes nothing
/// that counts; from there on only more rays that agree do.
std::vector<RenderSettings> candidates(const RenderSettings& settings, double allowed,
                                       int most_agree) {
    int agree = usual_agree(allowed);
    std::vector<RenderSettings> all;
    for (const int rays : {1, 2, 4}) all.push_back(with_rays(settings, rays));
    for (const double part : {0.7, 0.6, 0.5, 0.42}) {
        all.push_back(to_error(settings, two_digits(part * allowed), agree));
        if (part < 0.7) all.push_back(to_error(settings, two_digits(part * allowed), 2 * agree));
    }
    for (; agree <= most_agree; agree *= 2)
        all.push_back(to_error(settings, two_digits(least_part * allowed), agree));
    return all;
}

/// The pixels whose color depends on the choice of shadow rays.
std::vector<Pixel> in_penumbrae(TrialRunner& runner, const Trials& trials,
                                const RenderSettings& settings, const std::vector<Pixel>& pixels) {
    const std::vector<double> apart =
        distances(runner.render_pixels(trials, with_rays(settings, 1), pixels, 1),
                  runner.render_pixels(trials, with_rays(settings, 4), pixels, 2));
    std::vector<Pixel> found;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (apart[i] > runner.limit() / 8) found.push_back(pixels[i]);
    return found;
}

}  // namespace

Trial keep_tolerance(TrialRunner& runner, const Trials& trials, const RenderSettings& settings) {
    const double allowed = *runner.aim().tolerance;
    const std::vector<Pixel> all = runner.spread().pixels();
    const std::vector<Pixel> penumbrae = in_penumbrae(runner, trials, settings, all);
    const RenderSettings reference = reference_settings(settings, allowed);
    const std::vector<RenderSettings> tries = candidates(settings, allowed, reference.shadow_agree);
    constexpr std::size_t too_few = 30;
    if (!penumbrae.empty() && penumbrae.size() < too_few)
        return {.settings = tries.back(), .error = allowed};
    const double share = double(penumbrae.size()) / double(all.size());
    const double few = std::min(few_in_penumbrae, few_pixels / std::max(share, few_pixels));
    const std::vector<Pixel> pixels = some_of(penumbrae, enough_pixels);
    int round = 3;
    const TrialSample right = runner.render_pixels(trials, reference, pixels, round);
    Trial trial;
    for (const RenderSettings& tried : tries) {
        if (trial.error > 4 * allowed && tried.shadow_error == 0) continue;  // four times the rays
        trial = {.settings = tried};
        std::vector<double> off;
        // Those that keep the tolerance must do so with other random numbers too.
        for (int turn = 0; turn < 2 && trial.error <= allowed; ++turn) {
            for (const double apart :
                 distances(runner.render_pixels(trials, tried, pixels, ++round), right))
                off.push_back(apart / reference_bias(tried, reference));
            trial.error = error_but_for_share(few, off);
        }
        if (trial.error <= allowed) break;
    }
    return trial;
}

QualityLadder measure_ladder(TrialRunner& runner, const Trials& trials,
                             const RenderSettings& settings) {
    const std::vector<Pixel> scattered = runner.spread().pixels();
    const std::vector<Pixel> pixels =
        some_of(scattered, std::max(enough_pixels, scattered.size() / 8));
    const std::vector<RenderSettings> candidates = sampling_candidates(settings);
    const double time = *runner.aim().time;
    QualityLadder ladder;
    TrialSample finest = runner.render_pixels(trials, candidates[0], pixels, 1);
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const TrialSample before =
            std::exchange(finest, runner.render_pixels(trials, candidates[i], pixels, int(i) + 1));
        ladder.add({.settings = candidates[i - 1],
                    .seconds = runner.picture_seconds(before.seconds),
                    .rays = before.rays,
                    .error = error_but_for_share(few_pixels, distances(before, finest)) /
                             reference_bias(candidates[i - 1], candidates[i])});
        if (ladder.top().seconds > time) break;
        if (runner.no_time_left() && ladder.top().settings.shadow_error > 0) {
            ladder.extend({candidates.begin() + std::ptrdiff_t(i), candidates.end()}, time);
            break;
        }
    }
    return ladder;
}

std::string samples_in_words(const RenderSettings& settings) {
    if (settings.shadow_error == 0)
        return std::to_string(settings.shadow_samples) + " to a light with a size";
    return "until the estimated error of a light is below " + levels(settings.shadow_error) +
           (settings.shadow_agree > 0
                ? ", or " + std::to_string(settings.shadow_agree) + " rays agree"
                : "");
}

}  // namespace rt
