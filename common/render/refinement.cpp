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
    const auto compare_two = [&](Pixel a, Pixel b) {
        int most = 0;
        for (std::size_t i = 0; i < 3; ++i)
            most = std::max(most, std::abs(int(image[a][i]) - int(image[b][i])));
        if (most <= difference_) return;
        mark(a);
        mark(b);
    };
    for (int column = 0; column < size_.width; ++column) {
        const Pixel here{.row = row, .column = column};
        if (column + 1 < size_.width) compare_two(here, {row, column + 1});
        if (row + 1 < size_.height) compare_two(here, {row + 1, column});
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
