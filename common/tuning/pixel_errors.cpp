#include "common/tuning/pixel_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace rt {

namespace {

/// The largest difference of a component, of 255.
int largest_difference(const Rgb& a, const Rgb& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

DisplayColor display_color(const Rgb& rgb) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (rgb == not_a_color) return {nan, nan, nan};
    return {double(rgb[0]), double(rgb[1]), double(rgb[2])};
}

double distance(const DisplayColor& a, const DisplayColor& b) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::isnan(a[i]) != std::isnan(b[i])) return 255;
        if (!std::isnan(a[i])) most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

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

std::vector<double> distances(const TrialSample& a, const TrialSample& b) {
    std::vector<double> all;
    for (std::size_t i = 0; i < a.shades.size(); ++i)
        all.push_back(distance(a.shades[i], b.shades[i]));
    return all;
}

std::size_t allowed_outliers(std::size_t tried, double share) {
    if (share >= 1) return tried;
    const double expected = share * double(tried);
    return std::size_t(std::max(expected - certain_95 * std::sqrt(expected * (1 - share)), 0.));
}

double quantile(std::size_t allowed_outliers, std::vector<double> distances) {
    if (allowed_outliers >= distances.size()) return 0;
    const auto place = distances.end() - 1 - std::ptrdiff_t(allowed_outliers);
    std::ranges::nth_element(distances, place);
    return *place;
}

double error_but_for_share(double share, const std::vector<double>& distances) {
    if (distances.empty() || share >= 1) return 0;
    // With this many pixels, all within the tolerance, it follows with 95 % confidence that at most
    // the fraction `share` is not: (1 - share)^n = 0.05.
    const double enough = std::log(0.05) / std::log(1 - share);
    const double too_few = std::sqrt(std::max(enough / double(distances.size()), 1.));
    return too_few * quantile(allowed_outliers(distances.size(), share), distances);
}

double chance_beyond(double error, double allowed) {
    if (allowed < 1) return error > allowed ? 1 : 0;  // before rounding
    return std::clamp(error - std::floor(allowed), 0.0, 1.0);
}

double largest_share(double beyond, double tried, double all) {
    const double square = certain_95 * certain_95 * std::max(1 - tried / all, 0.0);
    const double share = beyond / tried;
    return (beyond + square / 2 +
            std::sqrt(square * (std::max(beyond * (1 - share), 0.0) + square / 4))) /
           (tried + square);
}

}  // namespace rt
