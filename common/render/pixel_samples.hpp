// The color of a pixel as the mean of several rays through it (--samples).
#pragma once

#include "common/image/pixel.hpp"
#include "common/render/context.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rt {
inline namespace RT_PRECISION {

/// Rays through the points of pixels. Stage 1 defines only the ray through a pixel's center, so the
/// points are the centers of the pixels of a finer picture of the same view.
class FinerRays {
public:
    FinerRays(const Camera& camera, Resolution resolution)
        : pixel_ray_(pixel_rays(
              camera, {.width = side * resolution.width, .height = side * resolution.height})) {}

    /// The finer picture's pixel at a point of [0, 1)² in the pixel.
    [[nodiscard]] static Pixel at(Pixel pixel, Vec2 point) {
        return {.row = side * pixel.row + int(side * point.y),
                .column = side * pixel.column + int(side * point.x)};
    }

    [[nodiscard]] Ray operator()(Pixel finer) const { return pixel_ray_(finer); }

private:
    /// The number of points in a row of a pixel. With a power of two and pictures of at most
    /// largest_side, float represents the center of every finer pixel exactly.
    static constexpr int side = 1024;

    PixelRays pixel_ray_;
};

/// The settings of each ray through a pixel, if there are several: they share its shadow rays. Each
/// sends a part of 1 / √N of them, so that the errors of edges and of shadows decrease alike.
[[nodiscard]] inline RenderSettings shared_settings(RenderSettings settings) {
    const double share = std::sqrt(double(settings.pixel_samples));
    const auto part = [share](int rays) { return int(std::ceil(rays / share)); };
    settings.shadow_samples = part(settings.shadow_samples);
    settings.shadow_agree = part(settings.shadow_agree);
    settings.shadow_error *= share;
    return settings;
}

/// Several rays through a pixel. Each counts as what a pixel can show of its color: components from
/// 0 to 1. The settings of the context are shared ones.
class PixelSamples {
public:
    /// The point of the ray number i depends on i and on `context.pixel`, which is usually `pixel`.
    /// The references must outlive this.
    PixelSamples(const Scene& scene, const FinerRays& rays, Pixel pixel, Context& context)
        : scene_(scene),
          rays_(rays),
          context_(context),
          pixel_(pixel),
          whole_(context.pixel),
          seed_(sample_seed(whole_, 0, 0)) {}  // the lights' numbers start at 1

    /// Traces rays up to this number.
    void trace_to(int count) {
        context_.whole_pixel = whole_;
        for (; count_ < count; ++count_) {
            const Vec2 point = spread_sample(std::uint32_t(count_), seed_);
            context_.sample = count_;
            context_.pixel = FinerRays::at(whole_, point);
            const Color color = trace(scene_, rays_(FinerRays::at(pixel_, point)), context_);
            for (std::size_t i = 0; i < parts_.size(); ++i)
                parts_[i].add(encoded(double(color[glm::length_t(i)]), Gamma::linear));
        }
        context_.pixel = whole_;
        context_.sample = -1;
    }

    [[nodiscard]] int count() const { return count_; }

    /// The mean color; a component is NaN if that of a ray is.
    [[nodiscard]] Color mean() const {
        Color color;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            color[glm::length_t(i)] = Real(parts_[i].sum / count_);
        return color;
    }

    /// The largest difference between two of the rays, of 255, in the given encoding.
    [[nodiscard]] double range(Gamma gamma) const {
        double largest = 0;
        for (const Part& part : parts_)
            largest = std::max(largest, encoded(part.most, gamma) - encoded(part.least, gamma));
        return 255 * largest;
    }

    /// The estimated error of the mean, of 255, in the given encoding.
    [[nodiscard]] double error(Gamma gamma) const {
        double largest = 0;
        for (const Part& part : parts_) {
            const double mean = part.sum / count_;
            const double error = part.error(count_);
            const double shown = encoded(mean, gamma);
            largest = std::max({largest, encoded(mean + error, gamma) - shown,
                                shown - encoded(mean - error, gamma)});
        }
        return 255 * largest;
    }

private:
    /// One component of the colors.
    struct Part {
        double sum = 0;
        double squares = 0;
        double least = 1;
        double most = 0;

        void add(double value) {
            sum += value;
            squares += value * value;
            least = std::min(least, value);
            most = std::max(most, value);
        }

        /// An edge between two colors that differ by d crosses about √n of the boxes that n
        /// well-spread points represent, and each of these has an error of about d / n of either
        /// sign: d / n^(3/4) in total, less if the edge cuts off only little (Mitchell 1996;
        /// visibility_error of stage 11 is the same for a light). The deviation, at most d / 2,
        /// shows how little.
        [[nodiscard]] double error(int count) const {
            constexpr double factor = 0.7;
            const double mean = sum / count;
            const double deviation = std::sqrt(std::max(squares / count - mean * mean, 0.0));
            return factor * std::sqrt(deviation * std::max(most - least, 0.0)) /
                   std::pow(count, 0.75);
        }
    };

    const Scene& scene_;
    const FinerRays& rays_;
    Context& context_;
    Pixel pixel_;
    Pixel whole_;
    std::uint32_t seed_;
    int count_ = 0;
    std::array<Part, 3> parts_{};
};

/// The settings of each ray through a pixel with --pixel-error: shared as by a typical number.
[[nodiscard]] inline RenderSettings adaptive_settings(RenderSettings settings) {
    constexpr int typical = 16;
    settings.pixel_samples = typical;
    return shared_settings(settings);
}

/// Traces rays through a pixel until the estimated error is that of the settings. Returns whether
/// their colors differ.
inline bool trace_to_error(PixelSamples& samples, const RenderSettings& settings) {
    const int most = settings.pixel_samples;
    int count = std::min(first_pixel_samples(settings.pixel_error), most);
    samples.trace_to(count);
    while (count < most && samples.error(settings.gamma) > settings.pixel_error) {
        count = next_pixel_samples(count, most);
        samples.trace_to(count);
    }
    return samples.range(settings.gamma) > 2 * settings.pixel_error;
}

/// The mean color of `context.settings.pixel_samples` rays through the pixel. The settings are
/// shared ones.
[[nodiscard]] inline Color mean_color(const Scene& scene, const FinerRays& rays, Pixel pixel,
                                      Context& context) {
    PixelSamples samples(scene, rays, pixel, context);
    samples.trace_to(context.settings.pixel_samples);
    return samples.mean();
}

}  // namespace RT_PRECISION
}  // namespace rt
