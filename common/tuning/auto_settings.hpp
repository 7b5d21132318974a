// Automatic render settings for a given tolerance or time: `--tolerance`, `--time`.
#pragma once

#include "common/tuning/time_budget.hpp"
#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// The settings that the command line fixes, and that are therefore not chosen.
struct Given {
    bool pixel_samples = false;   ///< then the error is that of a picture with this number
    bool shadow_samples = false;  ///< also set if the criterion to stop sampling is fixed
    bool depth = false;
};

/// The goal of the tuning, and the settings that are fixed.
struct Aim {
    RenderSettings settings;
    std::optional<double> tolerance;  ///< largest error of a pixel, in 8-bit levels
    std::optional<double> time;       ///< time for the picture, in seconds
    Given given;
    int threads = 1;
};

/// The automatic settings.
struct AutoSettings {
    bool in_float = false;  ///< render in float: accurate enough, and faster than double
    Trial expected;
    std::unique_ptr<TimeBudget> pace;  ///< set only if the picture has a time budget
    std::vector<std::string> reasons;  ///< report lines: each setting chosen, and the reason
};

/// Opens the same scene in float precision. Throws InputError if float cannot represent it.
using OpenFloat = std::function<Trials&()>;

/// Renders a few pixels of the scene with different settings, and chooses reflection depth,
/// precision, shadow samples and pixel samples, as far as the aim does not fix them and the scene
/// has a use for them. Without `open_float` the precision does not change. A time budget counts
/// from `start`. Returns nothing if `stop` was set.
[[nodiscard]] std::optional<AutoSettings> choose(Trials& trials, const OpenFloat& open_float,
                                                 const Aim& aim, Clock::time_point start,
                                                 const std::atomic<bool>& stop);

/// True if `trace` stops at settings.shadow_error. A student's trace of stage 11 does not: it has a
/// loop over all settings.shadow_samples, and may send a million rays to a light for each pixel.
/// The function renders a few pixels with an error of any size allowed, and compares the number of
/// their rays with that of the fewest samples that show an error.
[[nodiscard]] bool stops_sampling(const Trials& trials, const RenderSettings& settings);

}  // namespace rt
