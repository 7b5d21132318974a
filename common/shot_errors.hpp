// How far off a look is, told from a few pixels.
#pragma once

#include "common/trials.hpp"

namespace rt {

/// By how much the pixels of two shots differ: in the strongest channel, in 8-bit steps.
[[nodiscard]] std::vector<double> distances(const Shot& a, const Shot& b);

/// The share of the pixels that may be further off than the tolerance: so many of those tried that
/// with 95 % certainty no more than one in a hundred are, of all.
[[nodiscard]] double exceptions(std::size_t tried);

[[nodiscard]] double share_beyond(double limit, const std::vector<double>& distances);

/// All but such a share of the distances are no larger.
[[nodiscard]] double error_but_for(double share, std::vector<double> distances);

}  // namespace rt
