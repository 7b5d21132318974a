#include "common/image/color_scale.hpp"

#include "common/image/gamma.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rt {

namespace {

/// A color of Oklab in polar coordinates; the hue in turns.
struct Perceived {
    double lightness;
    double chroma;
    double hue;
};

/// Red, green and blue proportional to light; outside of 0 to 1 if a screen cannot show the color.
std::array<double, 3> light_of(const Perceived& color) {
    const double angle = 2 * std::numbers::pi * color.hue;
    const double a = color.chroma * std::cos(angle);
    const double b = color.chroma * std::sin(angle);
    const auto cubed = [](double x) { return x * x * x; };
    const double l = cubed(color.lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cubed(color.lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cubed(color.lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The color, or one with the same lightness and hue that a screen can show.
Rgb shown(Perceived color) {
    const auto outside = [](double light) { return light < 0 || light > 1; };
    std::array<double, 3> light = light_of(color);
    for (; std::any_of(light.begin(), light.end(), outside) && color.chroma > 0;
         light = light_of(color))
        color.chroma = std::max(color.chroma - 0.002, 0.0);
    Rgb rgb;
    for (std::size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = std::uint8_t(255 * encoded(light[i], Gamma::srgb) + 0.5);
    return rgb;
}

constexpr std::size_t steps = 256;

std::array<Rgb, steps> all_steps() {
    std::array<Rgb, steps> colors;
    for (std::size_t i = 0; i < steps; ++i) {
        const double share = double(i) / double(steps - 1);
        // The darkest one differs from black, which is the color where there is no number.
        colors[i] = shown({.lightness = 0.25 + 0.68 * share,
                           .chroma = 0.14 + 0.03 * share,
                           .hue = 0.84 - 0.54 * share});
    }
    return colors;
}

}  // namespace

Rgb scale_color(double share) {
    static const std::array<Rgb, steps> colors = all_steps();
    if (!(share > 0)) return colors.front();
    return colors[std::size_t(std::min(share, 1.0) * double(steps - 1) + 0.5)];
}

Rgb distinct_color(int number) {
    constexpr double golden_ratio = 0.6180339887498949;
    constexpr std::array lightness = {0.72, 0.56, 0.86};  // for neighbors on the circle of hues
    const double turns = 0.08 + golden_ratio * number;
    return shown({.lightness = lightness[std::size_t(number) % lightness.size()],
                  .chroma = 0.15,
                  .hue = turns - std::floor(turns)});
}

std::string hex(Rgb color) {
    return formatted("#%02x%02x%02x", color[0], color[1], color[2]);
}

}  // namespace rt
