// Renders sample pixels of a scene to measure the cost and the error of settings.
#pragma once

#include "common/tuning/auto_settings.hpp"
#include "common/tuning/trial_pixels.hpp"

namespace rt {

/// Thrown between trials when the program is to stop.
struct Stopped {};

/// Measures settings on sample pixels, and counts the pixels rendered.
class TrialRunner {
public:
    /// The flag must outlive this object.
    TrialRunner(Resolution size, const Aim& aim, const std::atomic<bool>& stop)
        : aim_(aim), stop_(stop), size_(size), spread_(size) {}

    [[nodiscard]] const Aim& aim() const { return aim_; }
    [[nodiscard]] Resolution size() const { return size_; }
    /// The number of pixels of the picture.
    [[nodiscard]] double pixels() const { return double(size_.width) * double(size_.height); }
    [[nodiscard]] const SpreadPixels& spread() const { return spread_; }

    /// The largest error that is not significant.
    [[nodiscard]] double limit() const;

    /// Renders the pixels with these settings. Another `round` uses other random samples. Throws
    /// Stopped if the program is to stop.
    [[nodiscard]] TrialSample render_pixels(const Trials& trials, const RenderSettings& settings,
                                            std::span<const Pixel> pixels, int round);

    /// Traces the histories of pixels, or renders the centers, as `trials` describes. Throws
    /// Stopped if the program is to stop.
    [[nodiscard]] TrialHistories trace_histories(const Trials& trials,
                                                 const RenderSettings& settings,
                                                 TrialRequest request);
    [[nodiscard]] TrialCenters render_centers(Trials& trials, const RenderSettings& settings);

    /// The estimated time of the whole picture on all threads, in seconds, if one pixel takes
    /// `of_a_pixel` seconds of CPU time.
    [[nodiscard]] double picture_seconds(double of_a_pixel) const;

    [[nodiscard]] double seconds_since_start() const;

    /// The part of the time budget that trials may take: a tenth of it, or infinity without one.
    [[nodiscard]] double seconds_for_trials() const;

    /// Returns whether the trials have used up their part of the time budget.
    [[nodiscard]] bool no_time_left() const { return seconds_since_start() > seconds_for_trials(); }

    [[nodiscard]] std::size_t pixels_drawn() const { return drawn_; }

    /// The rays of all trials, without those of the picture.
    [[nodiscard]] double rays_traced() const { return rays_; }

    /// The rays through the centers of pixels that the picture need not trace again, for each
    /// pixel.
    [[nodiscard]] double center_rays() const { return center_rays_; }

    /// The seconds by the clock that these took for the whole picture.
    [[nodiscard]] double center_seconds() const { return center_seconds_; }

private:
    void check_stop() const;

    Aim aim_;
    const std::atomic<bool>& stop_;
    Resolution size_;
    SpreadPixels spread_;
    Clock::time_point start_ = Clock::now();
    std::size_t drawn_ = 0;
    double rays_ = 0;
    double center_rays_ = 0;
    double center_seconds_ = 0;
};

/// Returns whether a picture of these settings begins with one ray through the center of each
/// pixel, which trials may have traced.
[[nodiscard]] inline bool begins_with_centers(const RenderSettings& settings) {
    return settings.pixel_error > 0 || settings.pixel_samples == 1;
}

/// The settings for trials of precision, depth and hierarchy: one shadow ray, unless the number is
/// fixed.
[[nodiscard]] RenderSettings with_one_shadow_ray(RenderSettings settings, const Aim& aim);

/// A picture with fewer rays through each pixel, from whose cost that of the whole one follows.
struct CheaperPicture {
    RenderSettings settings;
    double times = 1;  ///< the cost of the whole one, in these
};

/// A few of the rays, if a fixed number is given.
[[nodiscard]] CheaperPicture with_few_rays(RenderSettings settings);

}  // namespace rt
