// Settings for somebody who asks for a tolerance, or for a time: `--tolerance`, `--time`.
#pragma once

#include "common/ladder.hpp"
#include "common/pace.hpp"
#include "common/trials.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// Which settings are not to be chosen, because somebody has.
struct Given {
    bool shadow_samples = false;  ///< or when to stop sampling
    bool depth = false;
};

/// The goal of the settings, and those that are fixed.
struct Aim {
    Look look;
    std::optional<double> tolerance;  ///< an error of a pixel, in 8-bit steps
    std::optional<double> time;       ///< so many seconds
    Given given;
    std::optional<std::size_t> hierarchy_from;  ///< shapes of a kind, instead of where it pays
    int threads = 1;
};

struct Choice {
    bool in_float = false;                      ///< as well as in double, and sooner
    std::optional<std::size_t> hierarchy_from;  ///< as the aim's; nothing if it is as usual
    Trial expected;
    std::unique_ptr<Pace> pace;        ///< if the picture is to take a time
    std::vector<std::string> reasons;  ///< lines that say what was chosen, and why
};

/// Opens the same scene in float.
using OpenFloat = std::function<Trials&()>;

/// Tries the scene on a few pixels, and chooses hierarchy, depth, shadow samples and precision:
/// what the aim leaves open, and the scene requires. The trials that were chosen have their
/// hierarchies built. Without `open_float` the precision is as it is. A time is counted from
/// `start`. Nothing if it was stopped.
[[nodiscard]] std::optional<Choice> choose(Trials& trials, const OpenFloat& open_float,
                                           const Aim& aim, Clock::time_point start,
                                           const std::atomic<bool>& stop);

}  // namespace rt
