// The choice of the depth of mirror reflections.
#pragma once

#include "common/tuning/trial_runner.hpp"

namespace rt {

/// The smallest depth at which the omitted reflections are too weak to see: n reflections off
/// mirrors of strength m contribute with a weight of m^n. The tolerance is in 8-bit levels.
[[nodiscard]] int sufficient_depth(double strongest_mirror, double tolerance);

/// Returns the depth of the given settings, halved until the picture with one shadow ray per light
/// fits in the time budget.
[[nodiscard]] int depth_within_time(TrialRunner& runner, const Trials& trials,
                                    const RenderSettings& given);

}  // namespace rt
