// Trial pixels in penumbras, on which settings for area lights are compared.
#pragma once

#include "common/tuning/penumbrae.hpp"
#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <cstddef>
#include <vector>

namespace rt {

/// The pixels of a picture that need more than one ray to each light, and how many there are.
class PenumbraStudy {
public:
    /// Finds the pixels. `settings` are those to which sampling is added; `allowed` is the largest
    /// error of a pixel that keeps the tolerance.
    PenumbraStudy(TrialRunner& runner, const Trials& trials, const RenderSettings& settings,
                  double allowed);

    /// The settings of the right colors.
    [[nodiscard]] const RenderSettings& reference() const { return reference_; }

    /// The fraction of the picture in a penumbra, and its pixels.
    [[nodiscard]] double share() const { return share_; }
    [[nodiscard]] double pixels() const { return share_ * runner_.pixels(); }

    /// The rays of all trials so far.
    [[nodiscard]] double rays_spent() const { return rays_spent_; }

    /// Settings measured on the pixels.
    struct Judged {
        Trial trial;
        std::vector<double> off;  ///< error of each pixel, for each sample in turn
    };

    /// Measures the settings, on `fewest` errors of pixels or more. All settings are compared with
    /// the same rays.
    [[nodiscard]] Judged judged(RenderSettings settings, std::size_t fewest = 64);

    /// Measures them with other random rays, too.
    void judge_again(Judged& judged);

    /// Returns whether the tile with most pixels above the tolerance meets it, judged by all of its
    /// trial pixels.
    [[nodiscard]] bool worst_tile_keeps(const Judged& judged);

private:
    void sort_doubtful(const RenderSettings& one_ray);
    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const std::vector<Pixel>& pixels, int round);
    [[nodiscard]] double few() const;
    void judge(Judged& judged, std::size_t distances_known, int& round);
    void set_cost(Trial& trial, const TrialSample& in_penumbrae);

    TrialRunner& runner_;
    const Trials& trials_;
    double allowed_;
    int round_ = 2;  ///< as many as were looked for penumbrae with
    double rays_spent_ = 0;
    RenderSettings reference_;
    Penumbrae penumbrae_;
    std::vector<Pixel> pixels_;  ///< pixels in penumbras, for trials of settings
    TrialSample right_;          ///< those pixels rendered with the reference settings
    double share_ = 0;           ///< fraction of the picture that they represent
    std::vector<Pixel> calm_;    ///< other pixels that send rays to an area light
    double calm_share_ = 0;
    double without_light_rays_ = 0;  ///< number of other rays of a pixel
    double seconds_of_a_ray_ = 0;    ///< CPU seconds of one of them
};

}  // namespace rt
