// The choice of the number of rays through a pixel, together with that of shadow rays.
#pragma once

#include "common/tuning/pixel_study.hpp"
#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <string>

namespace rt {

/// Returns the settings that keep the tolerance with few rays, or the most accurate ones found:
/// one ray through each pixel, or more beside edges, or, where such edges are not all, more through
/// every pixel, and with them the shadow rays, unless they are given. The result is the same in
/// every run, because no clock decides.
[[nodiscard]] Trial keep_tolerance_of_pixels(TrialRunner& runner, Trials& trials,
                                             const RenderSettings& settings);

/// Measures settings for a time budget, cheapest first: with more rays beside edges, or, if there
/// is time for many, through every pixel. The settings of a ladder differ in thresholds only, or in
/// the number of rays only, so that each row of a picture can have its own.
[[nodiscard]] QualityLadder measure_pixel_ladder(TrialRunner& runner, const Trials& trials,
                                                 const RenderSettings& given);

/// Describes the rays through a pixel, for example "16".
[[nodiscard]] std::string pixels_in_words(const RenderSettings& settings);

}  // namespace rt
