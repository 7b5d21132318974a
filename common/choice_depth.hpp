// The choice of the depth of mirror reflections.
#pragma once

#include "common/trial_runner.hpp"

namespace rt {

/// The least depth at which what is left out cannot be seen: what a mirror reflects, m of it,
/// counts m^n after n of them.
[[nodiscard]] int sufficient_depth(double strongest_mirror, double tolerance);

/// Halved until the picture, with one shadow ray, takes no longer than the time.
[[nodiscard]] int depth_within_time(TrialRunner& runner, const Trials& trials, Look look);

}  // namespace rt
