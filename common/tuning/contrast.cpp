#include "common/tuning/contrast.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rt {

namespace {

/// The largest difference of a component, of 255.
int largest_difference(const Rgb& a, const Rgb& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

int contrast_around(const Image& image, Pixel pixel, int reach) {
    constexpr int most_places = 5;
    const auto [width, height] = image.resolution;
    std::array<const Rgb*, most_places> rows{};
    std::array<int, most_places> columns{};
    const int places = 2 * reach + 3;
    for (int i = 0; i < places; ++i) {
        const int row = std::clamp(pixel.row + i - reach - 1, 0, height - 1);
        rows[std::size_t(i)] = &image.pixels[std::size_t(row) * std::size_t(width)];
        columns[std::size_t(i)] = std::clamp(pixel.column + i - reach - 1, 0, width - 1);
    }
    int most = 0;
    const auto compare = [&](int row, int column, int next_row, int next_column) {
        const auto at = [&](int i, int j) { return rows[std::size_t(i)][columns[std::size_t(j)]]; };
        most = std::max(most, largest_difference(at(row, column), at(next_row, next_column)));
    };
    for (int line = 1; line + 1 < places; ++line)
        for (int place = 1; place < places; ++place) {
            compare(line, place - 1, line, place);
            compare(place - 1, line, place, line);
        }
    return most;
}

}  // namespace rt
