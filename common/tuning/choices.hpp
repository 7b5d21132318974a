// The choices, one after the other: depth, precision, shadow rays, and rays through pixels.
#pragma once

#include "common/tuning/auto_settings.hpp"
#include "common/tuning/pixel_study.hpp"
#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rt {

/// The smallest depth at which the omitted reflections are too weak to see: n reflections off
/// mirrors of strength m contribute with a weight of m^n. `levels` is the tolerance, of 255.
[[nodiscard]] inline int sufficient_depth(double strongest_mirror, double levels) {
    // The omitted reflections use at most an eighth of the tolerance; the samples use the rest.
    const double visible = levels / 8 / 255;
    if (strongest_mirror <= 0 || visible >= 1) return 0;
    if (strongest_mirror >= 1) return most_depth;
    const double reflections = std::log(visible) / std::log(strongest_mirror);
    return int(std::clamp(std::ceil(reflections) - 1, 0., double(most_depth)));
}

/// Returns the smallest depth with which some trial pixels have the color of the given, larger one,
/// but for an eighth of the tolerance, and their number.
struct SeenDepth {
    int depth = 0;
    std::size_t pixels = 0;
};
[[nodiscard]] SeenDepth seen_depth(TrialRunner& runner, const Trials& trials,
                                   const RenderSettings& deepest);

/// Returns a depth, at most that of the given settings, with which the picture with one shadow ray
/// per light takes up to half of the time budget: the rest is for trials, and for more rays.
[[nodiscard]] int depth_within_time(TrialRunner& runner, const Trials& trials,
                                    const RenderSettings& given);

/// The chosen precision, and the reason for the report.
struct PrecisionChoice {
    Trials* in_float = nullptr;  ///< the scene in float, if that is chosen
    std::string why;
};

/// Chooses float if the scene's sizes and gaps allow it, if the trials are cheap compared to what a
/// typical picture saves, and if float renders the same colors as double in pixels spread over the
/// whole picture, with the same shadow rays. The decision uses counts only, so that it is the same
/// in every run. Without `open_float` the precision is fixed.
[[nodiscard]] PrecisionChoice choose_precision(TrialRunner& runner, const Trials& trials,
                                               const SceneTraits& traits,
                                               const OpenFloat& open_float,
                                               const RenderSettings& settings);

/// Returns the settings that meet the tolerance with the fewest rays, or the most accurate ones
/// found. The result is the same in every run, because rays are counted instead of seconds.
[[nodiscard]] Trial keep_tolerance(TrialRunner& runner, const Trials& trials,
                                   const RenderSettings& settings);

/// Measures settings for a time budget, cheapest first, until one exceeds the budget or no time is
/// left for trials.
[[nodiscard]] QualityLadder measure_ladder(TrialRunner& runner, const Trials& trials,
                                           const RenderSettings& settings);

/// Describes the sampling, for example "until the estimated error of a light is below 0.7
/// levels, or 16 rays agree".
[[nodiscard]] std::string samples_in_words(const RenderSettings& settings);

/// Returns the settings with the rays to lights that are chosen with those through pixels. The only
/// ray through a pixel sends 8, 16 or 32 to each light: more if more of the pixels that a shape may
/// shade are in a penumbra, and at most 16 in a scene of many shapes. Each of several rays sends a
/// quarter of that. Where a shaft (shaft.hpp) leaves few shapes in the way, they take hardly longer
/// than one, and save rays through pixels. None stops early: rays that stop once a few agree would
/// make the mean of a pixel wrong, however many go through it. If the rays through the centers then
/// took more than a quarter of the time given, it is 4 to each light.
[[nodiscard]] RenderSettings with_few_shadow_rays(TrialRunner& runner, const Trials& trials,
                                                  const SceneTraits& traits,
                                                  const RenderSettings& settings);

/// Returns the settings that keep the tolerance with few rays, or the most accurate ones found:
/// one ray through each pixel, or more beside edges, or, where such edges are not all, more through
/// every pixel. The result is the same in every run, because no clock decides.
[[nodiscard]] Trial keep_tolerance_of_pixels(PixelStudy& study);

/// Measures settings for a time budget, cheapest first: with more rays beside edges, or, if
/// there is time for many, through every pixel. The settings of a ladder differ in thresholds only,
/// or in the number of rays only, so that each row of a picture can have its own.
[[nodiscard]] QualityLadder measure_pixel_ladder(const TrialRunner& runner, PixelStudy& study);

/// Describes the rays through a pixel, for example "16".
[[nodiscard]] std::string pixels_in_words(const RenderSettings& settings);

}  // namespace rt
