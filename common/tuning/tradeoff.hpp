// Render settings sorted from cheap to accurate.
#pragma once

#include "common/render/render_settings.hpp"

#include <vector>

namespace rt {

/// Render settings that have been measured.
struct Trial {
    RenderSettings settings;
    double seconds = 0;  ///< for the whole picture on all threads
    double rays = 0;     ///< mean for each pixel: unlike the seconds, the same in every run
    double error = 0;    ///< in 8-bit levels: 99 of 100 pixels have an error of at most this
    double beyond = 0;   ///< estimated share of the pixels that exceed the tolerance
    double at_most = 0;  ///< the same, with 95 % confidence
};

/// Settings sorted by cost. Clocks are noisy: a trial that seems faster than a cheaper one counts
/// as taking the same time, so that no time is negative and none decreases. A query beyond either
/// end returns that end. Between two settings that stop sampling at an error, or once rays agree,
/// it interpolates their thresholds, and between two numbers of rays through a pixel these.
class QualityLadder {
public:
    void add(Trial trial);

    /// Adds settings that were not measured, each with about 1/√2 of the error of the one before,
    /// up to those that exceed the time in seconds. Their error is given as that of the last trial,
    /// an upper bound.
    void extend(const std::vector<RenderSettings>& candidates, double seconds);

    /// Removes all settings that are finer than the first with at most this error.
    void end_at(double error);

    /// Subtracts these seconds from all, as they are spent before.
    void shorten(double seconds);

    [[nodiscard]] const Trial& top() const { return trials_.back(); }

    /// The most accurate settings that take at most this time in seconds.
    [[nodiscard]] Trial within_time(double seconds) const;

private:
    std::vector<Trial> trials_;  ///< their seconds do not decrease
};

}  // namespace rt
