#include "common/tuning/trial_pixels.hpp"

#include "common/system/hash.hpp"

#include <algorithm>
#include <cstdint>

namespace rt {

namespace {

/// The number of pixels above which cells are larger.
constexpr std::size_t large_picture = 160'000;

int cells(int pixels, int side) {
    return (pixels + side - 1) / side;
}

}  // namespace

int tile_of(Pixel pixel, Resolution size) {
    return pixel.row / tile_side * cells(size.width, tile_side) + pixel.column / tile_side;
}

SpreadPixels::SpreadPixels(Resolution size)
    : size_(size),
      side_(std::size_t(size.width) * std::size_t(size.height) > large_picture ? 8 : 4) {}

std::vector<Pixel> SpreadPixels::pixels(int draw) const {
    const int columns = cells(size_.width, side_);
    std::vector<Pixel> all;
    for (int row = 0; row < cells(size_.height, side_); ++row)
        for (int column = 0; column < columns; ++column) {
            const int height = std::min(side_, size_.height - row * side_);
            const int width = std::min(side_, size_.width - column * side_);
            const auto cell = std::uint32_t(row * columns + column);
            // An odd step visits all residues modulo a power of two before it repeats one.
            const std::uint32_t place =
                (mixed_bits(cell) + std::uint32_t(draw) * 11) % std::uint32_t(height * width);
            all.push_back({.row = row * side_ + int(place) / width,
                           .column = column * side_ + int(place) % width});
        }
    return all;
}

std::vector<Pixel> some_of(const std::vector<Pixel>& pixels, std::size_t count) {
    if (count == 0 || pixels.empty()) return {};
    const std::size_t step = std::max<std::size_t>(pixels.size() / count, 1);
    std::vector<Pixel> some;
    for (std::size_t i = 0; i < pixels.size(); i += step) some.push_back(pixels[i]);
    return some;
}

}  // namespace rt
