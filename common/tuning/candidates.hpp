// The candidate settings for sampling area lights.
#pragma once

#include "common/render/render_settings.hpp"

#include <vector>

namespace rt {

/// From one ray per light to an error of 1/32 of an 8-bit level. The error of each candidate is
/// about 1/√2 of the one before.
[[nodiscard]] std::vector<RenderSettings> sampling_candidates(RenderSettings settings);

/// Exactly `rays` rays to each light.
[[nodiscard]] RenderSettings with_rays(RenderSettings settings, int rays);

/// As many rays as needed for the error, or until the first `agree` rays agree.
[[nodiscard]] RenderSettings to_error(RenderSettings settings, double error, int agree);

/// A more expensive setting whose error is a known fraction of the tolerance: the reference for
/// measuring other settings.
[[nodiscard]] RenderSettings reference_settings(RenderSettings settings, double tolerance);

/// The factor by which a measured difference overestimates the error of `settings`, because the
/// reference `finer` has an error of its own.
[[nodiscard]] double reference_bias(const RenderSettings& settings, const RenderSettings& finer);

}  // namespace rt
