#include "common/tuning/time_budget.hpp"

#include <algorithm>
#include <utility>

namespace rt {

namespace {

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

}  // namespace

TimeBudget::TimeBudget(QualityLadder ladder, int rows, Clock::time_point end, double least_error)
    : ladder_(std::move(ladder)), rows_(rows), least_error_(least_error), start_(end), end_(end) {}

RenderSettings TimeBudget::next(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (given_ == 0) start_ = now;  // before are the rays through the centers (--pixel-error)
    // The measured slowdown compared to the expected times, damped because the first rows alone are
    // not representative.
    const double doubt = 0.02 * seconds(end_ - start_);
    const double slower = (seconds(now - start_) + doubt) / (expected_ + doubt);
    // The last rows do not get all that is left: one of them may take longer than the mean, and
    // rows beside edges that are found late follow.
    const int left = std::max({rows_ - given_, rows_ / 16, 1});
    // The trials may have taken all of the time, and more.
    const double all_rows = now < end_ ? seconds(end_ - now) / slower * rows_ / left : 0;
    const Trial trial = ladder_.within_time(all_rows);
    expected_ += trial.seconds / rows_;
    errors_ += trial.error;
    ++given_;
    return trial.settings;
}

}  // namespace rt
