// Tests whether a trace stops sampling a light at an error, before it has taken all samples.
#pragma once

#include "common/tuning/trial.hpp"

namespace rt {

/// True if `trace` stops at settings.shadow_error. A loop over all settings.shadow_samples, which
/// stage 11 asks of students, does not stop, and may send a million rays for each pixel and light.
/// The function renders a few pixels with an error of any size allowed, and compares the number of
/// their rays with that of the fewest samples that show an error.
[[nodiscard]] bool stops_sampling(const Trials& trials, const RenderSettings& settings);

}  // namespace rt
