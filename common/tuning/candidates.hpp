// The candidate settings for sampling area lights.
#pragma once

#include "common/render/render_settings.hpp"

#include <vector>

namespace rt {

/// From one ray per light to an error of 1/32 of an 8-bit level. The error of each candidate is
/// about 1/√2 of the one before.
[[nodiscard]] std::vector<Look> sampling_looks(Look look);

/// Exactly `rays` rays to each light.
[[nodiscard]] Look with_rays(Look look, int rays);

/// As many rays as needed for the error, or until the first `agree` rays agree.
[[nodiscard]] Look to_error(Look look, double error, int agree);

/// A more expensive setting whose error is a known fraction of the tolerance: the reference for
/// measuring other settings.
[[nodiscard]] Look reference_look(Look look, double tolerance);

/// The factor by which a measured difference overestimates the error of `look`, because the
/// reference `finer` has an error of its own.
[[nodiscard]] double excess(const Look& look, const Look& finer);

}  // namespace rt
