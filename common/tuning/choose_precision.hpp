// The choice between float and double precision.
#pragma once

#include "common/tuning/auto_settings.hpp"
#include "common/tuning/trial_runner.hpp"

namespace rt {

/// The chosen precision, and the reason for the report.
struct PrecisionChoice {
    Trials* in_float = nullptr;  ///< the scene in float, if that is chosen
    std::string why;
};

/// Chooses float if the scene's sizes and gaps allow it, if the trials are cheap compared to what a
/// typical picture saves, and if float renders the same colors as double in pixels spread over the
/// whole picture, with the same shadow rays. The decision uses counts only, so that it is the same
/// in every run. Without `open_float` the precision is fixed.
[[nodiscard]] PrecisionChoice choose_precision(TrialRunner& runner, const Trials& trials,
                                               const SceneTraits& traits,
                                               const OpenFloat& open_float,
                                               const RenderSettings& settings);

}  // namespace rt
