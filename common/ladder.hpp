// Looks from cheap to good.
#pragma once

#include "common/look.hpp"

#include <vector>

namespace rt {

/// A look that has been tried.
struct Trial {
    Look look;
    double seconds = 0;  ///< of the whole picture on all threads
    double error = 0;    ///< 8-bit steps: of 99 in 100 pixels, at most
};

/// The cheapest look first. Beyond the last, or before the first, is that one; between two that
/// stop sampling at an error, one that stops between these.
class Ladder {
public:
    void add(const Trial& trial) { trials_.push_back(trial); }

    [[nodiscard]] const Trial& top() const { return trials_.back(); }

    /// The best that takes no longer.
    [[nodiscard]] Trial within_time(double seconds) const;

    /// The cheapest that is off by no more.
    [[nodiscard]] Trial within_error(double error) const;

private:
    std::vector<Trial> trials_;
};

}  // namespace rt
