// Tests whether a trace stops sampling a light at an error, before it has taken all samples.
#pragma once

#include "common/tuning/trial.hpp"

namespace rt {

/// Returns whether `trace` stops at settings.shadow_error. A loop over all of
/// settings.shadow_samples, which is what stage 11 asks of a student, does not: up to a million of
/// them, for each pixel and light, would never end. Renders a few pixels whose error is allowed to
/// be of any size, and compares their rays with those of the fewest samples that show an error.
[[nodiscard]] bool stops_sampling(const Trials& trials, const RenderSettings& settings);

}  // namespace rt
