// Tests whether a trace stops sampling a light at an error, before it has taken all samples.
#pragma once

#include "common/tuning/trial.hpp"

namespace rt {

/// True if `trace` stops at settings.shadow_error. Stage 11 asks students for a loop over all
/// settings.shadow_samples: it does not stop, and may send a million rays to a light for each
/// pixel. The function renders a few pixels with an error of any size allowed, and compares the
/// number of their rays with that of the fewest samples that show an error.
[[nodiscard]] bool stops_sampling(const Trials& trials, const RenderSettings& settings);

}  // namespace rt
