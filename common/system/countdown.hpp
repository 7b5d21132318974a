// A time limit by the clock, as a precaution.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

namespace rt {

/// The time that is left of a limit. Of the time between two looks, at most a tenth of a second
/// counts: a process that looks more often and finds more time gone was stopped (Ctrl-Z, a
/// suspended job, a paused virtual machine) or waited for a processor.
class Countdown {
public:
    using Time = std::chrono::nanoseconds;

    /// The most that counts between two looks.
    static constexpr Time longest_look = std::chrono::milliseconds(100);

    explicit Countdown(Time limit) : left_(limit) {}

    /// Looks at the clock. Zero or less after the limit.
    [[nodiscard]] Time look() {
        const Clock::time_point now = Clock::now();
        left_ -= std::min<Time>(now - looked_, longest_look);
        looked_ = now;
        return left_;
    }

private:
    using Clock = std::chrono::steady_clock;

    Time left_;
    Clock::time_point looked_ = Clock::now();
};

// The clock of trials and measurements.

/// The processor time of this program so far, of all its threads together.
[[nodiscard]] inline double cpu_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace rt
