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
/// stop sampling at an error, or once rays agree, one that stops between these.
class Ladder {
public:
    void add(const Trial& trial) { trials_.push_back(trial); }

    /// The trial becomes the top: in place of all that are as dear.
    void end_with(const Trial& trial);

    [[nodiscard]] const Trial& top() const { return trials_.back(); }

    /// The best that takes no longer.
    [[nodiscard]] Trial within_time(double seconds) const;

    /// The cheapest that is off by no more.
    [[nodiscard]] Trial within_error(double error) const;

private:
    std::vector<Trial> trials_;
};

}  // namespace rt
