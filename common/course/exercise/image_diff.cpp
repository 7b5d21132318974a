#include "common/course/exercise/image_diff.hpp"

#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

namespace rt {

namespace {

constexpr int gap = 4;  // white, between pictures

int difference(Rgb a, Rgb b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Dark where the pictures agree, so that differences stand out and their places are visible.
Rgb shown_difference(Rgb mine, Rgb reference, int tolerated) {
    const int most = difference(mine, reference);
    if (most <= tolerated) {
        const auto gray =
            static_cast<std::uint8_t>((reference[0] + reference[1] + reference[2]) / 12);
        return {gray, gray, gray};
    }
    return {255, static_cast<std::uint8_t>(std::max(0, 200 - most)), 0};
}

void paste(const Image& image, Image& into, int left) {
    for (int row = 0; row < image.resolution.height; ++row)
        for (int column = 0; column < image.resolution.width; ++column)
            into[{row, left + column}] = image[{row, column}];
}

/// Removes the first pixel and all pixels connected to it from the set, and returns them.
std::vector<Pixel> take_cluster(std::vector<bool>& set, Resolution size, Pixel first) {
    std::vector<Pixel> cluster;
    std::vector<Pixel> todo = {first};
    while (!todo.empty()) {
        const Pixel pixel = todo.back();
        todo.pop_back();
        if (pixel.row < 0 || pixel.row >= size.height || pixel.column < 0 ||
            pixel.column >= size.width)
            continue;
        const std::size_t index = std::size_t(pixel.row) * size.width + pixel.column;
        if (!set[index]) continue;
        set[index] = false;
        cluster.push_back(pixel);
        for (int row = -1; row <= 1; ++row)
            for (int column = -1; column <= 1; ++column)
                todo.push_back({pixel.row + row, pixel.column + column});
    }
    return cluster;
}

/// The pixel of the cluster that is nearest to its mean.
Pixel middle(const std::vector<Pixel>& cluster) {
    double row = 0;
    double column = 0;
    for (const Pixel& pixel : cluster) {
        row += pixel.row;
        column += pixel.column;
    }
    row /= double(cluster.size());
    column /= double(cluster.size());
    const auto distance = [row, column](const Pixel& pixel) {
        return (pixel.row - row) * (pixel.row - row) +
               (pixel.column - column) * (pixel.column - column);
    };
    return *std::ranges::min_element(cluster, {}, distance);
}

std::optional<Pixel> center_of_largest(std::vector<bool> set, Resolution size) {
    std::vector<Pixel> largest;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (!set[i]) continue;
        std::vector<Pixel> cluster =
            take_cluster(set, size, {int(i) / size.width, int(i) % size.width});
        if (cluster.size() > largest.size()) largest = std::move(cluster);
    }
    if (largest.empty()) return std::nullopt;
    return middle(largest);
}

/// The sum of the differences of some pixels, and that of their squares.
struct Moments {
    double sum = 0;
    double squares = 0;

    void add(double difference) {
        sum += difference;
        squares += difference * difference;
    }
    /// True if the sum is as large as for independent differences of either sign, for which it is
    /// about the root of the sum of squares. For n differences of one sign it is √n times that.
    [[nodiscard]] bool is_random() const {
        constexpr double deviations = 4.5;
        return std::abs(sum) <= deviations * std::sqrt(squares);
    }
};

}  // namespace

bool is_noise(const Image& mine, const Image& reference) {
    constexpr int side = 16;
    constexpr std::size_t channels = 3;
    const Resolution size = reference.resolution;
    std::map<std::array<int, 3>, Moments> of_squares;
    std::array<Moments, channels> of_all;
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column)
            for (std::size_t i = 0; i < channels; ++i) {
                const double difference = double(mine[pixel][i]) - double(reference[pixel][i]);
                of_squares[{pixel.row / side, pixel.column / side, int(i)}].add(difference);
                of_all[i].add(difference);
            }
    return mine.pixels != reference.pixels && std::ranges::all_of(of_all, &Moments::is_random) &&
           std::ranges::all_of(of_squares,
                               [](const auto& each) { return each.second.is_random(); });
}

Comparison compare(const Image& mine, const Image& reference, int tolerated) {
    const Resolution size = reference.resolution;
    if (mine.resolution.width != size.width || mine.resolution.height != size.height)
        throw InputError({}, tr("the two pictures differ in size"));
    Comparison comparison;
    Image shown(size);
    std::vector<bool> differs(mine.pixels.size());
    for (std::size_t i = 0; i < mine.pixels.size(); ++i) {
        const int most = difference(mine.pixels[i], reference.pixels[i]);
        differs[i] = most > tolerated;
        comparison.different += differs[i] ? 1 : 0;
        comparison.most = std::max(comparison.most, most);
        shown.pixels[i] = shown_difference(mine.pixels[i], reference.pixels[i], tolerated);
    }
    comparison.center = center_of_largest(std::move(differs), size);
    comparison.side_by_side = Image({3 * size.width + 2 * gap, size.height});
    std::ranges::fill(comparison.side_by_side.pixels, Rgb{255, 255, 255});
    paste(mine, comparison.side_by_side, 0);
    paste(reference, comparison.side_by_side, size.width + gap);
    paste(shown, comparison.side_by_side, 2 * (size.width + gap));
    return comparison;
}

Image magnified(const Image& image, int times) {
    Image large({image.resolution.width * times, image.resolution.height * times});
    auto next = large.pixels.begin();
    for (auto row = image.pixels.begin(); row != image.pixels.end();) {
        const auto wide = next;
        for (const auto end = row + image.resolution.width; row != end; ++row)
            next = std::fill_n(next, times, *row);
        for (int i = 1; i < times; ++i) next = std::copy_n(wide, large.resolution.width, next);
    }
    return large;
}

std::string summary(const Comparison& comparison) {
    if (!comparison.center) return tr("the same picture as the reference's");
    const auto [row, column] = *comparison.center;
    const Resolution shown = comparison.side_by_side.resolution;
    return tr("{number} of {all} pixels differ, most around row,column {pixel}",
              {{"number", comparison.different},
               {"all", (shown.width - 2 * gap) / 3 * shown.height},
               {"pixel", std::to_string(row) + "," + std::to_string(column)}});
}

}  // namespace rt
