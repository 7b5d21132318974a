// The choice of the number of shadow rays to area lights.
#pragma once

#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <string>

namespace rt {

/// The largest fraction of the pixels whose error may exceed the tolerance.
inline constexpr double few_pixels = 0.01;
/// The same for the pixels in a penumbra, that is, those whose error with one ray per light would
/// exceed the tolerance.
inline constexpr double few_in_penumbrae = 0.1;
/// The same for the pixels of a single tile.
inline constexpr double few_in_a_tile = 0.1;

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
