// How far off a look is, told from a few pixels.
#pragma once

#include "common/trials.hpp"

namespace rt {

/// By how much two colors differ: in the strongest channel, in 8-bit steps.
[[nodiscard]] double distance(const Shade& a, const Shade& b);

/// By how much the pixels of two shots differ, likewise.
[[nodiscard]] std::vector<double> distances(const Shot& a, const Shot& b);

/// How many of those tried may be further off than the tolerance, so that with 95 % confidence no
/// more than this share is, of all.
[[nodiscard]] std::size_t exceptions(std::size_t tried, double share);

/// All but so many of the distances are no larger; 0 if that leaves none.
[[nodiscard]] double error_but_for(std::size_t exceptions, std::vector<double> distances);

/// No more than the share is further off than this, with 95 % confidence. Where so few are tried
/// that not even all of them would show it, it is more than all of them.
[[nodiscard]] double error_but_for_share(double share, const std::vector<double>& distances);

}  // namespace rt
