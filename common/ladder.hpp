// Looks from cheap to good.
#pragma once

#include "common/look.hpp"

#include <vector>

namespace rt {

/// A look that has been tried.
struct Trial {
    Look look;
    double seconds = 0;  ///< of the whole picture on all threads
    double rays = 0;     ///< of a pixel, in the mean: unlike the seconds the same in every run
    double error = 0;    ///< 8-bit steps: of 99 in 100 pixels, at most
};

/// The cheapest look first. A clock is never that exact: a trial that seems quicker than a cheaper
/// one is taken to last as long, so that no time is negative and none falls. Beyond the last, or
/// before the first, is that one; between two that stop sampling at an error, or once rays agree,
/// one that stops between these.
class Ladder {
public:
    void add(Trial trial);

    /// Looks that were not tried, each about 1/√2 of the error of the one before, up to those that
    /// take longer than the time. Their errors are told as that of the last trial, which is more.
    void extend(const std::vector<Look>& looks, double seconds);

    /// The trial becomes the top: in place of all that are as dear.
    void end_with(const Trial& trial);

    [[nodiscard]] const Trial& top() const { return trials_.back(); }

    /// The best that takes no longer.
    [[nodiscard]] Trial within_time(double seconds) const;

    /// The cheapest that is off by no more.
    [[nodiscard]] Trial within_error(double error) const;

private:
    std::vector<Trial> trials_;  ///< seconds do not fall
};

}  // namespace rt
