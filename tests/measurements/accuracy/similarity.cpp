#include "tests/measurements/accuracy/similarity.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace rt {

namespace {

constexpr int reach = 5;  // of the window, on each side of its pixel
constexpr int side = 2 * reach + 1;

/// The window of the article: a Gaussian of 1.5 pixels, whose weights add up to 1.
std::array<double, std::size_t(side)> window() {
    std::array<double, std::size_t(side)> weights{};
    double sum = 0;
    for (int i = 0; i < side; ++i)
        sum += weights[std::size_t(i)] = std::exp(-0.5 * std::pow((i - reach) / 1.5, 2));
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The index of one channel in the window around a pixel.
double local_similarity(const Image& a, const Image& b, Pixel middle, std::size_t channel) {
    static const auto weights = window();
    double x = 0;
    double y = 0;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Pixel pixel{.row = middle.row + row - reach,
                              .column = middle.column + column - reach};
            const double weight = weights[std::size_t(row)] * weights[std::size_t(column)];
            const double p = a[pixel][channel];
            const double q = b[pixel][channel];
            x += weight * p;
            y += weight * q;
            xx += weight * p * p;
            yy += weight * q * q;
            xy += weight * p * q;
        }
    const double c1 = std::pow(0.01 * 255, 2);  // the article's constants
    const double c2 = std::pow(0.03 * 255, 2);
    return (2 * x * y + c1) * (2 * (xy - x * y) + c2) /
           ((x * x + y * y + c1) * (xx - x * x + yy - y * y + c2));
}

}  // namespace

double structural_similarity(const Image& a, const Image& b) {
    double sum = 0;
    double count = 0;
    for (Pixel p{.row = reach}; p.row < a.resolution.height - reach; ++p.row)
        for (p.column = reach; p.column < a.resolution.width - reach; ++p.column)
            for (std::size_t channel = 0; channel < 3; ++channel, ++count)
                sum += local_similarity(a, b, p, channel);
    return sum / count;
}

}  // namespace rt
