// The choice of the depth of mirror reflections.
#pragma once

#include "common/tuning/trial_runner.hpp"

namespace rt {

/// The smallest depth at which the omitted reflections are too weak to see: n reflections off
/// mirrors of strength m contribute with a weight of m^n. The tolerance is in 8-bit levels.
[[nodiscard]] int sufficient_depth(double strongest_mirror, double tolerance);

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

}  // namespace rt
