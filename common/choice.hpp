// Settings for somebody who asks for a tolerance, or for a time: `--tolerance`, `--time`.
#pragma once

#include "common/ladder.hpp"
#include "common/pace.hpp"
#include "common/session.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt {

struct Choice {
    std::unique_ptr<Session> session;  ///< of the precision chosen, its hierarchies built
    Precision precision = Precision::f64;
    Trial expected;
    std::unique_ptr<Pace> pace;        ///< if the picture is to take a time
    std::vector<std::string> reasons;  ///< lines that say what was chosen, and why
};

/// Opens the same scene in another precision.
using Open = std::function<std::unique_ptr<Session>()>;

/// Tries the scene on a few pixels, and chooses hierarchy, depth, shadow samples and precision:
/// what the options leave open, and the scene requires. Without `open_float` the precision is the
/// session's. A time is counted from `start`. Nothing if it was stopped.
[[nodiscard]] std::optional<Choice> choose(std::unique_ptr<Session> session, const Open& open_float,
                                           const Options& options, Clock::time_point start,
                                           const std::atomic<bool>& stop);

}  // namespace rt
