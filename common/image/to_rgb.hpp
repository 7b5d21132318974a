// The 8-bit color of a pixel, from a color of any brightness.
#pragma once

#include "common/image/gamma.hpp"
#include "common/image/image.hpp"
#include "common/math/real.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rt {

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

}  // namespace rt
