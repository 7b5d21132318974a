// Sample pixels that represent a picture in trials: one in each cell of a grid.
#pragma once

#include "common/image/pixel.hpp"

#include <cstddef>
#include <vector>

namespace rt {

/// The side in pixels of the tiles in which a picture is judged.
inline constexpr int tile_side = 32;

/// The index of the tile that contains the pixel.
[[nodiscard]] int tile_of(Pixel pixel, Resolution size);

/// A grid of cells over a picture.
class SpreadPixels {
public:
    /// Uses cells of 4 x 4 pixels, or 8 x 8 in large pictures, so that each tile has 64 or 16
    /// cells.
    explicit SpreadPixels(Resolution size);

    /// One pixel in each cell, row by row. Another `draw` returns other pixels of the cells, up to
    /// the number of pixels in a cell.
    [[nodiscard]] std::vector<Pixel> pixels(int draw = 0) const;

    /// The number of different draws.
    [[nodiscard]] int draws() const { return side_ * side_; }

private:
    Resolution size_;
    int side_;  ///< of a cell, in pixels
};

/// Returns about `count` of the pixels, regularly spaced: every k-th, or all.
[[nodiscard]] std::vector<Pixel> some_of(const std::vector<Pixel>& pixels, std::size_t count);

}  // namespace rt
