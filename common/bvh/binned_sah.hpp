// Splitting of a sequence of bounding boxes by the surface area heuristic: the builder of a
// bounding volume hierarchy uses it.
#pragma once

#include "common/math/simd.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

/// A bounding box with one coordinate in each SIMD lane: x, y, z, and a lane that stays 0.
struct Box4 {
    static constexpr float end = std::numeric_limits<float>::infinity();

    Float4 min = broadcast_float(end);
    Float4 max = broadcast_float(-end);
};

/// The consecutive boxes from index begin up to, but not including, end.
struct PrimitiveRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    Box4 bounds;     ///< bounding box of all boxes in the range
    Box4 centroids;  ///< bounding box of their centers, times two

    [[nodiscard]] std::size_t size() const { return end - begin; }
};

[[nodiscard]] float half_area(const Box4& box);

/// The sequence of boxes. A split changes the order only inside its range.
class BinnedSah {
public:
    /// The boxes must lie between -1 and 1 along every axis. `leaf_size` is the largest number of
    /// boxes in a leaf, a power of two.
    BinnedSah(std::vector<Box4> boxes, std::uint32_t leaf_size);

    [[nodiscard]] const PrimitiveRange& all() const { return all_; }

    /// The indices of the boxes, in the current order of the sequence.
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }

    /// Splits the range at the plane of least cost by the surface area heuristic over binned
    /// centers (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies").
    /// Neither part is empty.
    [[nodiscard]] std::array<PrimitiveRange, 2> split(const PrimitiveRange& range);

    /// Splits the range at its middle index; the order does not change.
    [[nodiscard]] std::array<PrimitiveRange, 2> split_middle(const PrimitiveRange& range) const;

    /// Frees the memory of the boxes, after the last split.
    void free_boxes() { boxes_ = std::vector<Box4>(); }  // {} would keep the memory

private:
    struct Bin;
    struct Split;
    template <std::size_t slices>
    using Bins = std::array<std::array<Bin, slices>, 3>;

    [[nodiscard]] PrimitiveRange measured(std::size_t begin, std::size_t end) const;
    template <std::size_t slices>
    [[nodiscard]] Bins<slices> binned(const PrimitiveRange& range, std::size_t step) const;
    template <std::size_t slices>
    [[nodiscard]] Split cheapest(const Bins<slices>& bins) const;
    [[nodiscard]] float cost(const Bin& bin) const;
    template <std::size_t slices>
    [[nodiscard]] std::array<PrimitiveRange, 2> cut_between(const PrimitiveRange& range);

    std::vector<Box4> boxes_;
    std::vector<std::uint32_t> indices_;
    std::uint32_t leaf_size_;
    int leaf_shift_;  ///< its logarithm
    PrimitiveRange all_;
};

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
