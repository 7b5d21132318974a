// The whole picture, pixel by pixel, on several threads.
#pragma once

#include "common/image.hpp"
#include "common/look.hpp"
#include "common/stage.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

struct RenderSettings {
    int threads = 1;
    Look look;
    /// The look of each row in turn, if there is one: the picture is to take a time. Any thread
    /// calls.
    std::function<Look()> next_look = nullptr;
    std::function<void()> row_done = nullptr;  ///< called after each row, by any thread
    const std::atomic<bool>* stop = nullptr;   ///< set to give up
};

struct Rendering {
    Image image;
    std::int64_t rays = 0;
    std::int64_t sized_light_rays = 0;  ///< of these, to lights with a size
    std::int64_t not_a_number = 0;      ///< pixels without a colour
    Pixel first_not_a_number;           ///< the topmost of them
};

[[nodiscard]] inline bool is_number(const Color& color) {
    return !std::isnan(color.r) && !std::isnan(color.g) && !std::isnan(color.b);
}

/// The red, green and blue that show a colour: 0 to 1 becomes 0 to 255, and what is beyond is cut
/// off. A component that is NaN makes the whole not_a_color.
[[nodiscard]] inline Rgb to_rgb(const Color& color) {
    if (!is_number(color)) return not_a_color;
    const auto byte = [](Real value) {
        return std::uint8_t(std::min(std::max(value, Real(0)), Real(1)) * 255 + Real(0.5));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

/// The scene through its first camera: nothing if it was stopped. The same bits for any number of
/// threads, because no pixel depends on another, unless looks differ from row to row.
[[nodiscard]] std::optional<Rendering> render(const Scene& scene, const RenderSettings& settings);

}  // namespace rt
