// Rendering of a whole picture, pixel by pixel, on several threads. In stage 1, one thread is that
// stage's own loop.
#pragma once

#include "common/image/image.hpp"
#include "common/image/to_rgb.hpp"
#include "common/render/render_settings.hpp"
#include "common/render/stage.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

/// A rendered picture and its statistics.
struct Rendering {
    Image image;
    std::int64_t rays = 0;
    std::int64_t sized_light_rays = 0;  ///< of these, rays to area lights
    std::int64_t not_a_number = 0;      ///< pixels whose color is not a number
    Pixel first_not_a_number;           ///< the first of them, from the top
};

/// The arguments of `render` beside the scene.
struct RenderJob {
    int threads = 1;
    RenderSettings settings;
    /// If set, returns the settings of the next row; used with a time budget. Any thread calls it.
    std::function<RenderSettings()> next_settings = nullptr;
    std::function<void()> row_done = nullptr;  ///< called after each row, by any thread
    /// With pixel_error, called for each pixel that is the mean of several rays, with their number;
    /// by any thread.
    std::function<void(Pixel, int)> refined = nullptr;
    /// The result of render_centers with these settings, if there is one. It is moved from.
    Rendering* centers = nullptr;
    const std::atomic<bool>* stop =
        nullptr;  ///< rendering stops when this becomes true; may be null

    [[nodiscard]] bool is_stopped() const { return stop != nullptr && *stop; }
};

/// Renders the scene with its first camera. Returns nothing if it was stopped. The result has the
/// same bits for any number of threads, because no pixel depends on another, unless settings
/// differ from row to row.
[[nodiscard]] std::optional<Rendering> render(const Scene& scene, const RenderJob& job);

/// Renders one ray through the center of each pixel, with which --pixel-error starts. Returns
/// nothing if it was stopped.
[[nodiscard]] std::optional<Rendering> render_centers(const Scene& scene, const RenderJob& job);

}  // namespace rt
