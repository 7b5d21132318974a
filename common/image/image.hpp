// An image in memory, the same type in every precision.
#pragma once

#include "common/image/pixel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// Red, green and blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// The display color of a pixel whose color is not a number: magenta, which no scene of the course
/// uses.
inline constexpr Rgb not_a_color = {255, 0, 255};

/// Throws std::out_of_range with a sentence about the pixel.
[[noreturn]] void throw_outside(Pixel pixel, Resolution resolution);

/// Pixels in rows from the top, each row from the left.
struct Image {
    Resolution resolution{0, 0};
    std::vector<Rgb> pixels;

    Image() = default;
    explicit Image(Resolution size)
        : resolution(size), pixels(std::size_t(size.width) * std::size_t(size.height)) {}

    // A pixel outside of the picture throws std::out_of_range.
    [[nodiscard]] Rgb& operator[](Pixel pixel) { return pixels[index(pixel)]; }
    [[nodiscard]] const Rgb& operator[](Pixel pixel) const { return pixels[index(pixel)]; }

private:
    [[nodiscard]] std::size_t index(Pixel pixel) const {
        if (pixel.row < 0 || pixel.row >= resolution.height || pixel.column < 0 ||
            pixel.column >= resolution.width)
            throw_outside(pixel, resolution);
        return std::size_t(pixel.row) * std::size_t(resolution.width) + std::size_t(pixel.column);
    }
};

}  // namespace rt
