// What there is to try for lights with a size.
#pragma once

#include "common/look.hpp"

#include <vector>

namespace rt {

/// From one ray to a thirty-second of a step. Each look's error is about 1/√2 of the one's before.
[[nodiscard]] std::vector<Look> sampling_looks(Look look);

/// So many rays to each light, whatever they meet.
[[nodiscard]] Look with_rays(Look look, int rays);

/// As many rays as it takes to an error, or until so many agree.
[[nodiscard]] Look to_error(Look look, double error, int agree);

/// What others are compared with, to find out whether they keep the tolerance.
[[nodiscard]] Look reference_look(Look look, double tolerance);

/// Two shots differ by more than the first is off, since the finer one is off as well: by so much.
[[nodiscard]] double excess(const Look& look, const Look& finer);

}  // namespace rt
