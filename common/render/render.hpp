// Rendering of a whole picture, pixel by pixel, on several threads. In stage 1, one thread is that
// stage's own loop.
#pragma once

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"
#include "common/render/stage.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

/// The job of one call of render.
struct RenderJob {
    int threads = 1;
    RenderSettings settings;
    /// If set, returns the job of the next row; used with a time budget. Any thread calls it.
    std::function<RenderSettings()> next_look = nullptr;
    std::function<void()> row_done = nullptr;  ///< called after each row, by any thread
    const std::atomic<bool>* stop =
        nullptr;  ///< rendering stops when this becomes true; may be null
};

/// A rendered picture and its statistics.
struct Rendering {
    Image image;
    std::int64_t rays = 0;
    std::int64_t sized_light_rays = 0;  ///< of these, rays to area lights
    std::int64_t not_a_number = 0;      ///< pixels whose color is not a number
    Pixel first_not_a_number;           ///< the first of them, from the top
};

/// Returns whether no component of the color is NaN.
[[nodiscard]] inline bool is_number(const Color& color) {
    return !std::isnan(color.r) && !std::isnan(color.g) && !std::isnan(color.b);
}

/// Converts a color to 8-bit red, green and blue: 0 to 1 maps to 0 to 255, and values outside are
/// clamped. A color with a NaN component becomes not_a_color.
[[nodiscard]] inline Rgb to_rgb(const Color& color) {
    if (!is_number(color)) return not_a_color;
    const auto byte = [](Real value) {
        return std::uint8_t(std::min(std::max(value, Real(0)), Real(1)) * 255 + Real(0.5));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

/// As above, with the components encoded first.
[[nodiscard]] inline Rgb to_rgb(const Color& color, Gamma gamma) {
    if (gamma != Gamma::srgb) return to_rgb(color);
    return to_rgb({encoded(color.r, gamma), encoded(color.g, gamma), encoded(color.b, gamma)});
}

/// Renders the scene with its first camera. Returns nothing if it was stopped. The result has the
/// same bits for any number of threads, because no pixel depends on another, unless job differ
/// from row to row.
[[nodiscard]] std::optional<Rendering> render(const Scene& scene, const RenderJob& job);

}  // namespace rt
