// Where the picture's colors depend on which rays are sent to a light with a size.
#pragma once

#include "common/trial_runner.hpp"

#include <string>

namespace rt {

struct Penumbrae {
    std::vector<Pixel> doubtful;  ///< trial pixels in a penumbra or next to one, tile by tile
    std::vector<Pixel> clear;     ///< the others, one in each of their cells
    std::vector<Pixel> asked;     ///< of the clear ones those that send rays to a light with a size
    double share = 0;             ///< of the picture that the doubtful ones stand for
    int draws = 1;                ///< of doubtful pixels in their cells
};

/// Looks for pixels in which a few rays disagree, one in each cell, and at the borders of shadows
/// for more if only few were found. What rays can be off by less than an eighth of the tolerance
/// is none.
[[nodiscard]] Penumbrae find_penumbrae(TrialRunner& runner, const Trials& trials, const Look& look);

}  // namespace rt
