// How many rays go to lights with a size.
#pragma once

#include "common/ladder.hpp"
#include "common/trial_runner.hpp"

#include <string>

namespace rt {

/// No more of the pixels may be further off than the tolerance.
inline constexpr double few_pixels = 0.01;
/// Nor of those in a penumbra: those that one ray to a light would leave further off.
inline constexpr double few_in_penumbrae = 0.1;
/// Nor of any tile.
inline constexpr double few_in_a_tile = 0.1;

/// The look that keeps the tolerance with the fewest rays; or the best that was found. The same in
/// every run: rays are counted, not seconds.
[[nodiscard]] Trial keep_tolerance(TrialRunner& runner, const Trials& trials, const Look& look);

/// Looks for a time: the cheap ones first, until one takes too long, or there is no time for more.
[[nodiscard]] Ladder climb(TrialRunner& runner, const Trials& trials, const Look& look);

/// "until a light is estimated to be off by less than 0.7 steps, or 16 rays agree".
[[nodiscard]] std::string samples_in_words(const Look& look);

}  // namespace rt
