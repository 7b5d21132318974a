#include "common/bvh/binned_sah.hpp"

#include <numeric>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

namespace {

void grow(Box4& box, const Box4& other) {
    box.min = min(other.min, box.min);
    box.max = max(other.max, box.max);
}

/// The center, times two.
Float4 middle(const Box4& box) {
    return box.min + box.max;
}

/// The axes from `first` up to, but not including, `last`.
struct Axes {
    std::size_t first;
    std::size_t last;
};

/// For many boxes, only the axis along which their centers extend farthest: the split is as good,
/// and found in half the time.
Axes axes_to_try(const PrimitiveRange& range) {
    constexpr std::size_t many = 512;
    if (range.size() < many) return {.first = 0, .last = 3};
    const auto [x, y, z, none] = values(range.centroids.max - range.centroids.min);
    const std::size_t longest = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    return {.first = longest, .last = longest + 1};
}

/// From this size on, the split is chosen by a sample: every so many boxes. It is as good, and the
/// boxes are read from memory once a split in place of twice.
constexpr std::size_t sampled_from = 65536;
constexpr std::size_t sample_step = 16;

}  // namespace

/// Returns the function from the center of a box to its slice index along each axis. Where all
/// centers are equal, 0 · ∞ is NaN, and the slice is 0.
template <std::size_t slices>
auto slicer(const Box4& centroids) {
    const Float4 scale = broadcast_float(slices) / (centroids.max - centroids.min);
    return [scale, origin = centroids.min](Float4 middle) {
        const Float4 slice = (middle - origin) * scale;
        return values(min(max(slice, broadcast_float(0)), broadcast_float(slices - 1)));
    };
}

/// The boxes whose centers are in one slice of a range, along one axis.
struct BinnedSah::Bin {
    Box4 bounds;
    std::uint32_t count = 0;
};

/// The axis of a split, and the first slice of its upper part.
struct BinnedSah::Split {
    std::size_t axis = 0;
    std::size_t slice = 0;
    float cost = Box4::end;  ///< infinite if no split was found
};

float half_area(const Box4& box) {
    const auto [x, y, z, none] = values(box.max - box.min);
    return x * y + y * z + z * x;
}

BinnedSah::BinnedSah(std::vector<Box4> boxes, std::uint32_t leaf_size)
    : boxes_(std::move(boxes)),
      indices_(boxes_.size()),
      leaf_size_(leaf_size),
      leaf_shift_(std::countr_zero(leaf_size)) {
    std::iota(indices_.begin(), indices_.end(), 0);
    all_ = measured(0, boxes_.size());
}

PrimitiveRange BinnedSah::measured(std::size_t begin, std::size_t end) const {
    PrimitiveRange range{.begin = begin, .end = end};
    for (std::size_t i = begin; i < end; ++i) {
        grow(range.bounds, boxes_[i]);
        const Float4 center = middle(boxes_[i]);
        grow(range.centroids, {center, center});
    }
    return range;
}

/// The expected cost of a part for a ray that hits it: one step for each leaf that its boxes fill.
float BinnedSah::cost(const Bin& part) const {
    // A shift: a division by a variable would take as long as all the rest.
    const std::uint32_t leaves = (part.count + leaf_size_ - 1) >> leaf_shift_;
    return half_area(part.bounds) * float(leaves);
}

template <std::size_t slices>
BinnedSah::Bins<slices> BinnedSah::binned(const PrimitiveRange& range, std::size_t step) const {
    Bins<slices> bins;
    const auto slice_of = slicer<slices>(range.centroids);
    const auto [first, last] = axes_to_try(range);
    for (std::size_t i = range.begin; i < range.end; i += step) {
        const auto slice = slice_of(middle(boxes_[i]));
        for (std::size_t axis = first; axis < last; ++axis) {
            Bin& bin = bins[axis][std::size_t(slice[axis])];
            grow(bin.bounds, boxes_[i]);
            ++bin.count;
        }
    }
    return bins;
}

template <std::size_t slices>
BinnedSah::Split BinnedSah::cheapest(const Bins<slices>& bins) const {
    const auto add = [](Bin& part, const Bin& bin) {
        grow(part.bounds, bin.bounds);
        part.count += bin.count;
    };
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<float, slices> upper_cost;
        Bin upper;
        for (std::size_t i = slices - 1; i > 0; --i) {
            add(upper, bins[axis][i]);
            upper_cost[i] = cost(upper);
        }
        Bin lower;
        for (std::size_t i = 1; i < slices; ++i) {
            add(lower, bins[axis][i - 1]);
            const float both = cost(lower) + upper_cost[i];
            // An empty part costs ∞ · 0 = NaN, and is never a split.
            if (both < best.cost) best = {.axis = axis, .slice = i, .cost = both};
        }
    }
    return best;
}

std::array<PrimitiveRange, 2> BinnedSah::split(const PrimitiveRange& range) {
    // Most ranges contain few boxes: filling and scanning more bins would take most of the time.
    constexpr std::size_t few = 64;
    if (range.size() <= 2 * std::size_t(leaf_size_)) return cut_between<4>(range);
    return range.size() < few ? cut_between<8>(range) : cut_between<16>(range);
}

template <std::size_t slices>
std::array<PrimitiveRange, 2> BinnedSah::cut_between(const PrimitiveRange& range) {
    const std::size_t step = range.size() < sampled_from ? 1 : sample_step;
    const Bins<slices> bins = binned<slices>(range, step);
    const Split best = cheapest<slices>(bins);
    if (best.cost == Box4::end) return split_middle(range);  // all centers are in one slice

    PrimitiveRange lower;
    PrimitiveRange upper;
    for (std::size_t i = 0; i < slices; ++i)
        grow((i < best.slice ? lower : upper).bounds, bins[best.axis][i].bounds);

    const auto slice_of = slicer<slices>(range.centroids);
    const auto goes_lower = [&](std::size_t i) {
        const Float4 center = middle(boxes_[i]);
        const bool is_lower = std::size_t(slice_of(center)[best.axis]) < best.slice;
        PrimitiveRange& part = is_lower ? lower : upper;
        if (step > 1) grow(part.bounds, boxes_[i]);  // the bins have only those of the sample
        grow(part.centroids, {center, center});
        return is_lower;
    };
    std::size_t low = range.begin;
    std::size_t high = range.end;
    while (low < high) {
        if (goes_lower(low)) {
            ++low;
            continue;
        }
        do --high;
        while (low < high && !goes_lower(high));
        if (low < high) {
            std::swap(boxes_[low], boxes_[high]);
            std::swap(indices_[low], indices_[high]);
            ++low;
        }
    }
    lower.begin = range.begin;
    lower.end = upper.begin = low;
    upper.end = range.end;
    return {lower, upper};
}

std::array<PrimitiveRange, 2> BinnedSah::split_middle(const PrimitiveRange& range) const {
    const std::size_t middle = range.begin + range.size() / 2;
    return {measured(range.begin, middle), measured(middle, range.end)};
}

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
