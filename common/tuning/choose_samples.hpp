// The choice of the number of shadow rays to area lights.
#pragma once

#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <string>

namespace rt {

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

}  // namespace rt
