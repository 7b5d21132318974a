// What there is to try for lights with a size.
#pragma once

#include "common/look.hpp"

#include <vector>

namespace rt {

/// From one ray to a thirty-second of a step. Each look's error is about 1/√2 of the one's before.
[[nodiscard]] std::vector<Look> sampling_looks(Look look);

/// One that leaves a part of the look's error, and is dear.
[[nodiscard]] Look finer_than(Look look);

/// Two shots differ by more than the first is off, since the finer one is off as well: by so much.
[[nodiscard]] double excess(const Look& look, const Look& finer);

/// Most pixels are in full light or in none, and most of the rays are spent to make sure of it.
/// Where few are in a penumbra, rays that agree may be believed, if these are sampled better: to
/// this part of the error.
inline constexpr double better_sampled = 0.8;

/// Looks about as good as this one, the cheap ones first.
[[nodiscard]] std::vector<Look> looks_around(Look look);

/// Rays are believed earlier, and those that differ sampled better still.
[[nodiscard]] Look fewer_agree(Look look);

}  // namespace rt
