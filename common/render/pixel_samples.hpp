// The color of a pixel as the mean of several rays through it (--samples).
#pragma once

#include "common/image/pixel.hpp"
#include "common/render/context.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The settings of each ray through a pixel, if there are several: they share its shadow rays.
[[nodiscard]] inline RenderSettings shared_settings(RenderSettings settings) {
    const double share = std::sqrt(double(settings.pixel_samples));
    const auto part = [share](int rays) { return int(std::ceil(rays / share)); };
    settings.shadow_samples = part(settings.shadow_samples);
    settings.shadow_agree = part(settings.shadow_agree);
    settings.shadow_error *= share;
    return settings;
}

/// The mean color of `context.settings.pixel_samples` rays through the pixel, of which each shows
/// what a pixel can: parts from 0 to 1. If one is not a number, the mean is not. The settings are
/// shared ones.
[[nodiscard]] inline Color mean_color(const Scene& scene, const FinerRays& rays, Pixel pixel,
                                      Context& context) {
    const Pixel whole = context.pixel;
    const std::uint32_t seed = sample_seed(whole, 0, 0);  // the lights' numbers start at 1
    const int count = context.settings.pixel_samples;
    std::array<double, 3> sum{};
    context.whole_pixel = whole;
    for (context.sample = 0; context.sample < count; ++context.sample) {
        const Vec2 point = spread_sample(std::uint32_t(context.sample), seed);
        context.pixel = FinerRays::at(whole, point);
        const Color color = trace(scene, rays(FinerRays::at(pixel, point)), context);
        for (glm::length_t i = 0; i < 3; ++i)
            sum[std::size_t(i)] += encoded(double(color[i]), Gamma::linear);
    }
    context.pixel = whole;
    context.sample = -1;
    return {Real(sum[0] / count), Real(sum[1] / count), Real(sum[2] / count)};
}

}  // namespace RT_PRECISION
}  // namespace rt
