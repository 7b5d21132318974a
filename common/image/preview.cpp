#include "common/image/preview.hpp"

#include <algorithm>

namespace rt {

namespace {

/// The mean color of a block of the picture, of at least one pixel.
Rgb mean(const Image& image, Pixel from, Pixel to) {
    to = {.row = std::max(to.row, from.row + 1), .column = std::max(to.column, from.column + 1)};
    std::array<std::int64_t, 3> sum{};
    for (int row = from.row; row < to.row; ++row)
        for (int column = from.column; column < to.column; ++column)
            for (std::size_t i = 0; i < 3; ++i) sum[i] += image[{row, column}][i];
    const auto count = std::int64_t(to.row - from.row) * (to.column - from.column);
    Rgb color{};
    for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<std::uint8_t>(sum[i] / count);
    return color;
}

/// The image scaled down to at most `width` columns and an even number of rows, with its aspect
/// ratio kept.
Image shrunk(const Image& image, int width) {
    const int full_width = image.resolution.width;
    const int full_height = image.resolution.height;
    width = std::min(width, full_width);
    const auto scaled = std::int64_t(full_height) * width / full_width / 2 * 2;
    const int height = std::max(int(scaled), 2);
    Image small(Resolution{width, height});
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const auto place = [&](int i, int j) {
                return Pixel{int(std::int64_t(i) * full_height / height),
                             int(std::int64_t(j) * full_width / width)};
            };
            small[{row, column}] = mean(image, place(row, column), place(row + 1, column + 1));
        }
    }
    return small;
}

std::string color_code(const char* ground, Rgb color) {
    std::string code = std::string("\033[") + ground;
    for (const std::uint8_t part : color) code += ";" + std::to_string(part);
    return code + "m";
}

}  // namespace

std::string preview(const Image& image, int columns) {
    const Image small = shrunk(image, columns);
    std::string text;
    for (int row = 0; row + 1 < small.resolution.height; row += 2) {
        for (int column = 0; column < small.resolution.width; ++column) {
            text += color_code("38;2", small[{row, column}]);  // foreground: the upper half block
            text += color_code("48;2", small[{row + 1, column}]);  // background: the lower half
            text += "▀";
        }
        text += "\033[0m\n";
    }
    return text;
}

}  // namespace rt
