// The choice of the depth of mirror reflections.
#pragma once

#include "common/tuning/trial_runner.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace rt
