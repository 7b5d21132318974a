// Many boxes in a row, and where to cut the row in two: what a hierarchy is built from.
#pragma once

#include "common/wide.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// A box with a coordinate a lane: x, y, z, and one that stays 0.
struct WideBox {
    static constexpr float end = std::numeric_limits<float>::infinity();

    Floats min = all_floats(end);
    Floats max = all_floats(-end);
};

/// Boxes that stand one after the other, from begin to before end.
struct BoxRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    WideBox bounds;   ///< of the boxes
    WideBox middles;  ///< of their centres, times two

    [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Half the surface of a box.
[[nodiscard]] float half_area(const WideBox& box);

/// The row. Cutting a range changes the order inside it only.
class BoxRanges {
public:
    /// The boxes, between -1 and 1 along every axis, and how many of them a leaf holds at most.
    BoxRanges(std::vector<WideBox> boxes, std::size_t leaf_size);

    [[nodiscard]] const BoxRange& all() const { return all_; }

    /// The boxes' indices in the row's order.
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }

    /// Cut where the surface area heuristic over binned centres says (Wald 2007, "On fast
    /// Construction of SAH-based Bounding Volume Hierarchies"), neither part empty.
    [[nodiscard]] std::array<BoxRange, 2> cut(const BoxRange& range);

    /// Cut in the middle, as the range stands.
    [[nodiscard]] std::array<BoxRange, 2> halves(const BoxRange& range) const;

private:
    struct Bin;
    struct Cut;
    template <std::size_t slices>
    class Slicer;
    template <std::size_t slices>
    using Bins = std::array<std::array<Bin, slices>, 3>;

    [[nodiscard]] BoxRange measured(std::size_t begin, std::size_t end) const;
    template <std::size_t slices>
    [[nodiscard]] Bins<slices> binned(const BoxRange& range) const;
    template <std::size_t slices>
    [[nodiscard]] Cut cheapest(const Bins<slices>& bins) const;
    [[nodiscard]] float cost(const Bin& bin) const;
    template <std::size_t slices>
    [[nodiscard]] std::array<BoxRange, 2> cut_between(const BoxRange& range);

    std::vector<WideBox> boxes_;
    std::vector<std::uint32_t> indices_;
    std::size_t leaf_size_;
    BoxRange all_;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
