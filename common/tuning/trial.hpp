// The interface between the automatic settings and a scene: the traits of the scene, and samples of
// its pixels.
#pragma once

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"
#include "common/tuning/scene_lengths.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// The traits of a scene that affect the choice of settings.
struct SceneTraits {
    SceneLengths lengths;  ///< without the gap
    bool sized_lights = false;
    double shininess = 1;  ///< largest exponent of a highlight
    bool shadows = false;
    double strongest_mirror = 0;  ///< largest mirror strength of a shape
    std::size_t shapes = 0;       ///< number of shapes, with the triangles of meshes
    double unit_roundoff = 0;     ///< unit roundoff of the precision
};

/// A color as displayed but not rounded: 0 to 255 for each component.
using DisplayColor = std::array<double, 3>;

/// The pixels of a trial, and the way to render them.
struct TrialRequest {
    std::span<const Pixel> pixels;
    int round = 0;     ///< each round uses its own random samples
    int at_least = 0;  ///< of a history: the least number of rays through every pixel
    int scouts = 0;    ///< other rays before a history, which is traced only if they find something
    const Image* centers = nullptr;  ///< what scouts find is another color than here
    double visible = 0;              ///< by more than this, in 8-bit levels
    int threads = 1;
    const std::atomic<bool>* stop =
        nullptr;  ///< rendering stops when this becomes true; may be null
};

/// The colors and the cost of the pixels of a trial. The rays are the same in every run, the
/// seconds are not.
struct TrialSample {
    std::vector<DisplayColor> shades;  ///< in the order of the pixels
    std::vector<int> light_rays;       ///< for each pixel: rays to area lights
    double rays = 0;                   ///< mean number of rays of all kinds for each pixel
    double seconds = 0;                ///< mean CPU seconds for each pixel
};

/// A pixel after some number of rays through it.
struct PixelStep {
    int count = 0;  ///< of these rays
    DisplayColor mean{};
    double error = 0;  ///< as --pixel-error estimates it, in 8-bit levels
    double rays = 0;   ///< of all kinds, so far
    double off = 0;    ///< estimated error of the mean, by PixelStudy
};

/// A pixel after each number of rays at which --pixel-error may stop, and after fewer. The rays are
/// those of the picture. Empty if scouts found nothing.
struct PixelHistory {
    static constexpr int fewest = 4;

    /// The number of rays of the step after that of `count` rays.
    [[nodiscard]] static constexpr int next(int count) {
        int power = 2 * fewest;
        if (count < power) return power;
        while (2 * power <= count) power *= 2;
        return count + power / 4;
    }

    /// The index of the step after `count` rays, a number at which --pixel-error may stop.
    [[nodiscard]] static constexpr std::size_t step_of(int count) {
        if (count < 2 * fewest) return 0;
        const auto power = std::bit_floor(unsigned(count));
        const auto doublings = std::size_t(std::bit_width(power / (2 * fewest)) - 1);
        return 1 + 4 * doublings + (unsigned(count) - power) / (power / 4);
    }

    /// The second run has other random numbers, and ends with as many rays.
    std::array<std::vector<PixelStep>, 2> runs;
    double ray_rays = 1;    ///< rays of all kinds for each through the pixel
    double stands_for = 1;  ///< the number of pixels like this one among those that scouts pass
    double followed = 0;    ///< the picture follows an edge to here if it differs by more than this

    [[nodiscard]] bool is_traced() const { return !runs[0].empty(); }
    /// The mean of both runs.
    [[nodiscard]] DisplayColor mean() const {
        DisplayColor both{};
        for (std::size_t i = 0; i < both.size(); ++i)
            both[i] = (runs[0].back().mean[i] + runs[1].back().mean[i]) / 2;
        return both;
    }
};

/// The shapes narrower than a pixel, and the gaps between shapes.
struct FineShapes {
    std::vector<float> parts;  ///< for each pixel, the smallest part of it that one may
                               ///< cover; 1 if none does. Empty if there are none.
    std::string narrowest;     ///< kind of the narrowest, as "sphere" or "gap beside a sphere"
    double width = 0;          ///< of that, in pixels

    /// Returns whether more than one pixel in a thousand has some: fewer cannot break the promise.
    [[nodiscard]] bool matter() const {
        return std::ranges::count_if(parts, [](float part) { return part < 1; }) * 1000 >
               std::ptrdiff_t(parts.size());
    }
};

/// The histories of the pixels of a trial, and their cost.
struct TrialHistories {
    std::vector<PixelHistory> pixels;
    double rays = 0;     ///< total, of all kinds
    double seconds = 0;  ///< total CPU seconds
};

/// The picture of one ray through the center of each pixel, and its cost.
struct TrialCenters {
    const Image* image = nullptr;  ///< until the next call
    double rays = 0;               ///< mean number of rays of all kinds for each pixel
    double seconds = 0;            ///< mean CPU seconds for each pixel
};

/// A scene on which settings can be measured.
class Trials {
public:
    Trials() = default;
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;
    virtual ~Trials() = default;

    [[nodiscard]] virtual Resolution resolution() const = 0;
    [[nodiscard]] virtual SceneTraits traits() const = 0;

    /// The shapes that the picture's rays may miss.
    [[nodiscard]] virtual FineShapes fine_shapes() const { return {}; }

    /// The gap of scene_lengths, which takes up to a second to find.
    [[nodiscard]] virtual double smallest_gap() const = 0;

    /// Renders the pixels, with settings that have no pixel_error. The result does not depend on
    /// the number of threads. If stopped early, it is meaningless.
    [[nodiscard]] virtual TrialSample render_pixels(const RenderSettings& settings,
                                                    const TrialRequest& request) const = 0;

    /// Traces rays through the pixels, at least `request.at_least` and at most
    /// `settings.pixel_samples`, until the estimated error is `settings.pixel_error`, and one ray
    /// less of what was seen would change the mean by no more. If stopped early, the result is
    /// meaningless.
    [[nodiscard]] virtual TrialHistories trace_histories(const RenderSettings& settings,
                                                         const TrialRequest& request) const = 0;

    /// Renders one ray through the center of each pixel. A picture of these settings, whatever its
    /// pixel_error, is then rendered without them. If stopped early, the result is meaningless.
    [[nodiscard]] virtual TrialCenters render_centers(const RenderSettings& settings,
                                                      const TrialRequest& request) = 0;
};

}  // namespace rt
