#include "common/render/refinement.hpp"

#include <algorithm>
#include <cstdlib>

namespace rt {

Refinement::Refinement(Resolution size, double difference)
    : size_(size),
      difference_(difference),
      states_(std::size_t(size.width) * std::size_t(size.height)),
      pending_(std::size_t(size.height)) {}

void Refinement::compare(const Image& image, int row) {
    const int last_column = size_.width - 1;
    const Rgb* const here = &image[{row, 0}];
    const Rgb* const below = row + 1 < size_.height ? &image[{row + 1, 0}] : here;
    const int least = int(difference_) + 1;  // the least whole number above it
    const auto differ = [least](const Rgb& a, const Rgb& b) {
        return std::abs(a[0] - b[0]) >= least || std::abs(a[1] - b[1]) >= least ||
               std::abs(a[2] - b[2]) >= least;
    };
    for (int column = 0; column <= last_column; ++column) {
        const int next = std::min(column + 1, last_column);
        const bool right = differ(here[column], here[next]);
        const bool down = differ(here[column], below[column]);
        if (!right && !down) [[likely]]
            continue;
        mark({row, column});
        if (right) mark({row, next});
        if (down) mark({std::min(row + 1, size_.height - 1), column});
    }
}

void Refinement::mark(Pixel pixel) {
    State expected = State::unmarked;
    if (states_[index(pixel)].compare_exchange_strong(expected, State::marked))
        pending_[std::size_t(pixel.row)] = true;
}

void Refinement::mark_around(Pixel pixel) {
    const int last_row = std::min(pixel.row + 1, size_.height - 1);
    const int last_column = std::min(pixel.column + 1, size_.width - 1);
    for (int row = std::max(pixel.row - 1, 0); row <= last_row; ++row)
        for (int column = std::max(pixel.column - 1, 0); column <= last_column; ++column)
            mark({.row = row, .column = column});
}

}  // namespace rt
