// Prints how much a picture differs from a larger one, in levels of 255: shrunk_difference SMALL
// LARGE. Each pixel is compared with the mean of those that it covers in the larger picture;
// printed is the mean of all differences, and that of the worst tile of 16 x 16 pixels.
#include "common/image/png.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <vector>

namespace {

constexpr int tile = 16;

/// The mean difference of the three components.
double difference(const rt::Image& small, const rt::Image& large, rt::Pixel pixel) {
    const int scale = large.resolution.width / small.resolution.width;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double mean = 0;
        for (int row = 0; row < scale; ++row)
            for (int column = 0; column < scale; ++column)
                mean += large[{pixel.row * scale + row, pixel.column * scale + column}][i];
        sum += std::abs(mean / (scale * scale) - small[pixel][i]);
    }
    return sum / 3;
}

void print_differences(const rt::Image& small, const rt::Image& large) {
    const auto [width, height] = small.resolution;
    const int columns = (width + tile - 1) / tile;
    std::vector<double> sums(std::size_t(columns) * std::size_t((height + tile - 1) / tile));
    double sum = 0;
    for (rt::Pixel pixel; pixel.row < height; ++pixel.row)
        for (pixel.column = 0; pixel.column < width; ++pixel.column) {
            const double here = difference(small, large, pixel);
            sum += here;
            sums[std::size_t(pixel.row / tile * columns + pixel.column / tile)] += here;
        }
    std::printf("%.2f %.2f\n", sum / (width * height),
                *std::max_element(sums.begin(), sums.end()) / (tile * tile));
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count != 3) throw rt::InputError({}, "expected shrunk_difference SMALL LARGE");
        const rt::Image small = rt::read_png(words[1]);
        const rt::Image large = rt::read_png(words[2]);
        const int scale = large.resolution.width / small.resolution.width;
        if (scale < 1 || large.resolution.width != scale * small.resolution.width ||
            large.resolution.height != scale * small.resolution.height)
            throw rt::InputError({words[2]}, "is not a whole number of times as large");
        print_differences(small, large);
        return 0;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
