// The time budget of a picture: each row is rendered with the best settings that the remaining time
// allows.
#pragma once

#include "common/tuning/tradeoff.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace rt {

using Clock = std::chrono::steady_clock;

/// Distributes a time budget over the rows of a picture.
class TimeBudget {
public:
    /// A budget for `rows` rows of about equal cost, from the first call of `next` until `end`. The
    /// times in the ladder are for all rows together, and may be wrong by a factor. Its trials
    /// cannot show an error below `least_error`.
    TimeBudget(QualityLadder ladder, int rows, Clock::time_point end, double least_error = 0);

    /// Returns the settings for the next row. Thread-safe.
    [[nodiscard]] RenderSettings next(Clock::time_point now = Clock::now());

    /// The mean expected error of the rows started so far, in the units of Trial::error, and not
    /// below the least.
    [[nodiscard]] double error() const {
        return std::max(least_error_, given_ == 0 ? 0 : errors_ / given_);
    }

private:
    std::mutex mutex_;
    QualityLadder ladder_;
    int rows_;
    int given_ = 0;
    double expected_ = 0;  ///< expected seconds of the rows started
    double errors_ = 0;
    double least_error_;
    Clock::time_point start_;
    Clock::time_point end_;
};

}  // namespace rt
