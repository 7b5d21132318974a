// Adaptive sampling (--pixel-error): more rays only where a picture needs them.
#pragma once

#include "common/image/image.hpp"
#include "common/render/pixel_samples.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// The pixels of a picture of one ray a pixel that get more rays. A pixel does if a neighbor has
/// another color, or if a neighbor got more rays and these differ: an edge is followed from pixel
/// to pixel, even where it is so thin that every ray through a center misses it. Which pixels these
/// are does not depend on the order in which they are found. It takes a byte a pixel.
class Refinement {
public:
    /// Two colors differ if a component does by more than `difference`, of 255.
    Refinement(Resolution size, double difference);

    /// Marks the pixels of a row, and of the next, that differ from a neighbor in these two rows.
    void compare(const Image& image, int row);

    /// Returns whether pixels of the row are marked and not yet taken.
    [[nodiscard]] bool is_pending(int row) const { return pending_[std::size_t(row)]; }

    /// Takes the marked pixels of a row: refine(pixel) returns whether its rays differ, which marks
    /// its neighbors.
    template <class Refine>
    void take(int row, Refine refine) {
        while (pending_[std::size_t(row)].exchange(false))
            for (Pixel pixel{.row = row}; pixel.column < size_.width; ++pixel.column) {
                std::atomic<State>& state = states_[index(pixel)];
                if (state != State::marked) continue;
                state = State::taken;
                if (refine(pixel)) mark_around(pixel);
            }
    }

private:
    enum class State : std::uint8_t { unmarked, marked, taken };

    [[nodiscard]] std::size_t index(Pixel pixel) const {
        return std::size_t(pixel.row) * std::size_t(size_.width) + std::size_t(pixel.column);
    }
    void mark(Pixel pixel);
    void mark_around(Pixel pixel);

    Resolution size_;
    double difference_;
    std::vector<std::atomic<State>> states_;
    std::vector<std::atomic<bool>> pending_;  ///< of each row
};

}  // namespace RT_PRECISION
}  // namespace rt
