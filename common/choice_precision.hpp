// Whether float will do.
#pragma once

#include "common/choice.hpp"
#include "common/trial_runner.hpp"

namespace rt {

struct PrecisionChoice {
    bool in_float = false;
    std::string why;
};

/// Float, if the scene's sizes and gaps allow it, its trials cost little beside the picture, and it
/// draws what double draws: in pixels spread over the whole picture, the same ones with the same
/// shadow rays. Decided by counts alone, so that it is the same in every run. Without `open_float`
/// the precision is given.
[[nodiscard]] PrecisionChoice choose_precision(TrialRunner& runner, const Trials& trials,
                                               const Demands& demands, const OpenFloat& open_float,
                                               const Choice& choice);

}  // namespace rt
