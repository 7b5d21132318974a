// Pixels of a scene, drawn to find out what a setting costs and gives.
#pragma once

#include "common/choice.hpp"
#include "common/trial_pixels.hpp"

#include <algorithm>
#include <utility>

namespace rt {

/// Thrown between trials, once the program is to stop.
struct Stopped {};

class TrialRunner {
public:
    /// The aim and the flag must outlive it.
    TrialRunner(Resolution size, const Aim& aim, const std::atomic<bool>& stop)
        : aim_(aim), stop_(stop), size_(size), spread_(size) {}

    [[nodiscard]] const Aim& aim() const { return aim_; }
    [[nodiscard]] Resolution size() const { return size_; }
    [[nodiscard]] const SpreadPixels& spread() const { return spread_; }

    /// What an error may be before it counts.
    [[nodiscard]] double limit() const;

    [[nodiscard]] Shot shot(const Trials& trials, const Look& look, std::span<const Pixel> pixels,
                            int round);

    /// Of the whole picture, on all threads, if a pixel takes so long.
    [[nodiscard]] double picture_seconds(double of_a_pixel) const;

    /// Which of two, each made ready, takes how long for a pixel: the least of a few tries in turn.
    template <class First, class Second>
    [[nodiscard]] std::pair<double, double> in_turn(const Look& look, std::span<const Pixel> pixels,
                                                    First first, Second second);

    [[nodiscard]] double seconds_since_start() const;

    /// Trials may take a tenth of the time, if there is one.
    [[nodiscard]] bool no_time_left() const;

    [[nodiscard]] std::size_t pixels_drawn() const { return drawn_; }

private:
    const Aim& aim_;
    const std::atomic<bool>& stop_;
    Resolution size_;
    SpreadPixels spread_;
    Clock::time_point start_ = Clock::now();
    std::size_t drawn_ = 0;
};

template <class First, class Second>
std::pair<double, double> TrialRunner::in_turn(const Look& look, std::span<const Pixel> pixels,
                                               First first, Second second) {
    constexpr int turns = 3;
    std::pair least{shot(first(), look, pixels, 0).seconds,
                    shot(second(), look, pixels, 0).seconds};
    for (int i = 1; i < turns; ++i) {
        least.first = std::min(least.first, shot(first(), look, pixels, 0).seconds);
        least.second = std::min(least.second, shot(second(), look, pixels, 0).seconds);
    }
    return least;
}

/// What a precision, a depth or a hierarchy is tried with: one shadow ray, if more are not given.
[[nodiscard]] Look with_one_shadow_ray(Look look, const Aim& aim);

}  // namespace rt
