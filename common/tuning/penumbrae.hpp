// Detection of penumbras: the parts of the picture whose colors depend on the choice of shadow rays
// to area lights.
#pragma once

#include "common/tuning/trial_runner.hpp"

#include <vector>

namespace rt {

/// The trial pixels of a picture, classified.
struct Penumbrae {
    std::vector<Pixel> doubtful;  ///< trial pixels in a penumbra or next to one, sorted by tile
    std::vector<Pixel> clear;     ///< the other trial pixels, one for each cell
    std::vector<Pixel> asked;     ///< the clear pixels that send rays to an area light
    double share = 0;             ///< fraction of the picture that the doubtful pixels represent
    int draws = 1;                ///< number of doubtful pixels drawn from each cell
};

/// Finds the pixels in which a few shadow rays disagree: one trial pixel in each cell, and more at
/// the borders of shadows if only few were found. A pixel whose possible error is below an eighth
/// of the tolerance is not counted as a penumbra.
[[nodiscard]] Penumbrae find_penumbrae(TrialRunner& runner, const Trials& trials,
                                       const RenderSettings& settings);

/// Estimates, from fewer pixels, which share of those that send rays to an area light is in a
/// penumbra: the same settings with other shadow rays give another color. The share is rather too
/// large than too small, and infinite if no pixel sends any.
[[nodiscard]] double share_in_penumbrae(TrialRunner& runner, const Trials& trials,
                                        const RenderSettings& settings);

}  // namespace rt
