// Pixels that stand for a picture in trials: one somewhere in each cell of a grid.
#pragma once

#include "common/pixel.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace rt {

/// A picture is judged in tiles of so many pixels by as many.
inline constexpr int tile_side = 32;

/// The number of the tile that has the pixel.
[[nodiscard]] int tile_of(Pixel pixel, Resolution size);

class SpreadPixels {
public:
    /// Cells of 4 x 4 pixels, in large pictures 8 x 8, so that every tile has 64 or 16 of them.
    explicit SpreadPixels(Resolution size);

    /// One in each cell, row by row. Another draw has others of the cells' pixels, up to the number
    /// of pixels in a cell.
    [[nodiscard]] std::vector<Pixel> pixels(int draw = 0) const;

    /// Of marked cells: those, and the ones that touch a marked one.
    [[nodiscard]] std::vector<bool> with_neighbors(const std::vector<bool>& marked) const;

    /// The cells of which one that touches them differs, by their numbers.
    template <class Differ>
    [[nodiscard]] std::vector<bool> differing_neighbors(Differ differ) const {
        std::vector<bool> all(std::size_t(rows_) * std::size_t(columns_));
        const auto compare = [&](int a, int b) {
            if (differ(std::size_t(a), std::size_t(b)))
                all[std::size_t(a)] = all[std::size_t(b)] = true;
        };
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                const int cell = row * columns_ + column;
                if (column + 1 < columns_) compare(cell, cell + 1);
                if (row + 1 < rows_) compare(cell, cell + columns_);
            }
        return all;
    }

private:
    Resolution size_;
    int side_;
    int rows_;
    int columns_;
};

/// About so many of the pixels, evenly: every k-th, or all. Different parts, 0 or 1, share none if
/// there are enough for both.
[[nodiscard]] std::vector<Pixel> some_of(const std::vector<Pixel>& pixels, std::size_t count,
                                         int part = 0);

}  // namespace rt
