// A picture that is to take a given time: each row is drawn as well as the time left allows.
#pragma once

#include "common/ladder.hpp"

#include <chrono>
#include <mutex>

namespace rt {

using Clock = std::chrono::steady_clock;

class Pace {
public:
    /// For so many rows that take about the same, until `end`. The ladder's times are those of all
    /// rows together, and may be wrong by a factor.
    Pace(Ladder ladder, int rows, Clock::time_point end, Clock::time_point start = Clock::now());

    /// The look of the next row. Any thread may ask.
    [[nodiscard]] Look next(Clock::time_point now = Clock::now());

    /// What the rows given so far are expected to be off by, in their mean: as Trial::error.
    [[nodiscard]] double error() const { return given_ == 0 ? 0 : errors_ / given_; }

private:
    std::mutex mutex_;
    Ladder ladder_;
    int rows_;
    int given_ = 0;
    double expected_ = 0;  ///< seconds, for the rows given
    double errors_ = 0;
    Clock::time_point start_;
    Clock::time_point end_;
};

}  // namespace rt
