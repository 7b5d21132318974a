#include "common/hierarchy.hpp"

#include <cmath>
#include <future>
#include <numeric>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

namespace {

/// How many boxes a leaf holds at most, if they are asked about one by one.
constexpr std::size_t single_leaf_size = 2;

/// Below this node, ranges are halved where they stand, so that no set of boxes makes the tree
/// deeper than Hierarchy::max_depth.
constexpr std::size_t cheapest_depth = 32;

/// From this size on, a part of the tree is grown by a thread of its own.
constexpr std::size_t thread_size = 32768;

/// A box with a coordinate a lane: x, y, z, and one that stays 0.
struct WideBox {
    Lanes min = all_lanes(infinity);
    Lanes max = all_lanes(-infinity);
};

void grow(WideBox& box, const WideBox& other) {
    box.min = min(other.min, box.min);
    box.max = max(other.max, box.max);
}

void grow(WideBox& box, Lanes point) {
    grow(box, {.min = point, .max = point});
}

/// Twice the centre.
Lanes middle(const WideBox& box) {
    return box.min + box.max;
}

WideBox widened(const Box& box) {
    return {.min = lanes_of({box.min.x, box.min.y, box.min.z, 0}),
            .max = lanes_of({box.max.x, box.max.y, box.max.z, 0})};
}

Box narrowed(const WideBox& box) {
    const auto min = values(box.min);
    const auto max = values(box.max);
    return {.min = {min[0], min[1], min[2]}, .max = {max[0], max[1], max[2]}};
}

Real largest_coordinate(const Box& box) {
    const Vec3 size = glm::max(abs(box.min), abs(box.max));
    return glm::max(size.x, glm::max(size.y, size.z));
}

/// Boxes that stand one after the other, from begin to before end.
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    WideBox bounds;   ///< of the boxes
    WideBox middles;  ///< of their middles

    [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// The boxes whose middles lie in one slice of a range, along one axis.
struct Bin {
    WideBox bounds;
    std::size_t count = 0;
};

/// Numbers the slices of a range.
struct Slices {
    static constexpr std::size_t count = 16;

    Lanes origin;
    Lanes scale;

    explicit Slices(const WideBox& middles)
        : origin(middles.min), scale(all_lanes(Real(count)) / (middles.max - middles.min)) {}

    /// Of each coordinate. Where all middles are the same, 0 · ∞ is slice 0.
    [[nodiscard]] std::array<Real, lane_count> operator()(Lanes middle) const {
        const Lanes slice = (middle - origin) * scale;
        return values(min(max(slice, all_lanes(0)), all_lanes(Real(count - 1))));
    }
};

/// Where to cut a range in two.
struct Cut {
    std::size_t axis = 0;
    std::size_t slice = 0;  ///< the first of the upper part
    Real cost = infinity;   ///< infinite: nowhere
};

/// Four boxes that no ray meets.
Node empty_node() {
    Node node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        node.planes[2 * axis] = all_lanes(infinity);
        node.planes[2 * axis + 1] = all_lanes(-infinity);
    }
    node.children.fill(Node::leaf_bit);
    return node;
}

void set_lane(Lanes& lanes, std::size_t i, Real value) {
    auto all = values(lanes);
    all[i] = value;
    lanes = lanes_of(all);
}

using Bins = std::array<std::array<Bin, Slices::count>, 3>;

}  // namespace

/// Builds from the top, cutting where the surface area heuristic over binned middles says (Wald
/// 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies").
class HierarchyBuilder {
public:
    HierarchyBuilder(std::span<const Box> boxes, Hierarchy::Leaves leaves);

    [[nodiscard]] Hierarchy build();

private:
    [[nodiscard]] Range measured(std::size_t begin, std::size_t end) const;
    [[nodiscard]] Bins binned(const Range& range) const;
    [[nodiscard]] Cut cheapest_cut(const Bins& bins) const;
    [[nodiscard]] std::array<Range, 2> halves(const Range& range, bool cheapest);
    [[nodiscard]] std::size_t parted(const Range& range, const Cut& cut, WideBox& lower,
                                     WideBox& upper);
    [[nodiscard]] std::vector<Range> children(const Range& range, std::size_t depth);
    [[nodiscard]] std::uint32_t grow_tree(Hierarchy& tree, const Range& range, std::size_t depth);
    [[nodiscard]] static std::uint32_t append(Hierarchy& tree, const Hierarchy& part);
    [[nodiscard]] std::uint32_t add_leaf(Hierarchy& tree, const Range& range) const;
    void set_child(Node& node, std::size_t i, const WideBox& box, std::uint32_t child) const;
    [[nodiscard]] Real half_area(const WideBox& box) const;
    [[nodiscard]] Real leaf_cost(std::size_t count) const;

    std::vector<WideBox> boxes_;
    std::vector<std::uint32_t> indices_;
    std::size_t leaf_size_ = 1;
    Lanes scale_;    ///< makes every coordinate at most 1, so that no area overflows
    Lanes padding_;  ///< of every box in a node
};

HierarchyBuilder::HierarchyBuilder(std::span<const Box> boxes, Hierarchy::Leaves leaves)
    : indices_(boxes.size()),
      leaf_size_(leaves == Hierarchy::Leaves::packed ? lane_count : single_leaf_size) {
    boxes_.reserve(boxes.size());
    for (const Box& box : boxes) boxes_.push_back(widened(box));
    std::iota(indices_.begin(), indices_.end(), 0);
}

/// Half the surface of the box; NaN if it is empty or endless.
Real HierarchyBuilder::half_area(const WideBox& box) const {
    const auto [x, y, z, none] = values(box.max * scale_ - box.min * scale_);
    return x * y + y * z + z * x;
}

Real HierarchyBuilder::leaf_cost(std::size_t count) const {
    return Real((count + leaf_size_ - 1) / leaf_size_);
}

Range HierarchyBuilder::measured(std::size_t begin, std::size_t end) const {
    Range range{.begin = begin, .end = end};
    for (std::size_t i = begin; i < end; ++i) {
        grow(range.bounds, boxes_[i]);
        grow(range.middles, middle(boxes_[i]));
    }
    return range;
}

Bins HierarchyBuilder::binned(const Range& range) const {
    Bins bins;
    const Slices slices(range.middles);
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const auto slice = slices(middle(boxes_[i]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[axis][std::size_t(slice[axis])];
            grow(bin.bounds, boxes_[i]);
            ++bin.count;
        }
    }
    return bins;
}

Cut HierarchyBuilder::cheapest_cut(const Bins& bins) const {
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<Real, Slices::count> upper_cost{};
        Bin upper;
        for (std::size_t i = Slices::count - 1; i > 0; --i) {
            grow(upper.bounds, bins[axis][i].bounds);
            upper.count += bins[axis][i].count;
            upper_cost[i] = half_area(upper.bounds) * leaf_cost(upper.count);
        }
        Bin lower;
        for (std::size_t i = 1; i < Slices::count; ++i) {
            grow(lower.bounds, bins[axis][i - 1].bounds);
            lower.count += bins[axis][i - 1].count;
            const Real cost = half_area(lower.bounds) * leaf_cost(lower.count) + upper_cost[i];
            // NaN, where one of the two is empty, is no cut.
            if (cost < best.cost) best = {.axis = axis, .slice = i, .cost = cost};
        }
    }
    return best;
}

/// Brings the boxes of the lower part before those of the upper, and says where these begin.
std::size_t HierarchyBuilder::parted(const Range& range, const Cut& cut, WideBox& lower,
                                     WideBox& upper) {
    const Slices slices(range.middles);
    std::size_t low = range.begin;
    std::size_t high = range.end;
    while (low < high) {
        const Lanes middle_of_low = middle(boxes_[low]);
        if (std::size_t(slices(middle_of_low)[cut.axis]) < cut.slice) {
            grow(lower, middle_of_low);
            ++low;
        } else {
            grow(upper, middle_of_low);
            --high;
            std::swap(boxes_[low], boxes_[high]);
            std::swap(indices_[low], indices_[high]);
        }
    }
    return low;
}

std::array<Range, 2> HierarchyBuilder::halves(const Range& range, bool cheapest) {
    const Bins bins = binned(range);
    const Cut cut = cheapest ? cheapest_cut(bins) : Cut{};
    if (cut.cost == infinity) {  // all in one place: any two halves
        const std::size_t middle = range.begin + range.size() / 2;
        return {measured(range.begin, middle), measured(middle, range.end)};
    }
    std::array<Range, 2> parts;
    for (std::size_t i = 0; i < Slices::count; ++i)
        grow(parts[i < cut.slice ? 0 : 1].bounds, bins[cut.axis][i].bounds);
    const std::size_t middle = parted(range, cut, parts[0].middles, parts[1].middles);
    parts[0].begin = range.begin;
    parts[0].end = parts[1].begin = middle;
    parts[1].end = range.end;
    return parts;
}

/// Up to four parts of a range: whichever has the largest surface is cut next.
std::vector<Range> HierarchyBuilder::children(const Range& range, std::size_t depth) {
    std::vector<Range> parts = {range};
    while (parts.size() < lane_count) {
        std::size_t widest = parts.size();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i].size() <= leaf_size_) continue;
            // A NaN area is the largest.
            if (widest == parts.size() ||
                !(half_area(parts[i].bounds) <= half_area(parts[widest].bounds)))
                widest = i;
        }
        if (widest == parts.size()) break;
        const auto [lower, upper] = halves(parts[widest], depth < cheapest_depth);
        parts[widest] = lower;
        parts.push_back(upper);
    }
    return parts;
}

std::uint32_t HierarchyBuilder::add_leaf(Hierarchy& tree, const Range& range) const {
    Leaf leaf;
    std::copy_n(indices_.begin() + std::ptrdiff_t(range.begin), range.size(), leaf.indices.begin());
    tree.leaves_.push_back(leaf);
    return std::uint32_t(tree.leaves_.size() - 1) | Node::leaf_bit;
}

void HierarchyBuilder::set_child(Node& node, std::size_t i, const WideBox& box,
                                 std::uint32_t child) const {
    const auto lowest = values(box.min - padding_);
    const auto highest = values(box.max + padding_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        set_lane(node.planes[2 * axis], i, lowest[axis]);
        set_lane(node.planes[2 * axis + 1], i, highest[axis]);
    }
    node.children[i] = child;
}

/// Appends the part's nodes and leaves, and says by what its root is named now.
std::uint32_t HierarchyBuilder::append(Hierarchy& tree, const Hierarchy& part) {
    const auto nodes = std::uint32_t(tree.nodes_.size());
    const auto leaves = std::uint32_t(tree.leaves_.size());
    const auto renamed = [&](std::uint32_t child) {
        return child + ((child & Node::leaf_bit) != 0 ? leaves : nodes);
    };
    for (Node node : part.nodes_) {
        for (std::uint32_t& child : node.children) child = renamed(child);
        tree.nodes_.push_back(node);
    }
    tree.leaves_.insert(tree.leaves_.end(), part.leaves_.begin(), part.leaves_.end());
    return renamed(part.root_);
}

/// Appends the range's tree to what there is, and says by what it is named there.
std::uint32_t HierarchyBuilder::grow_tree(Hierarchy& tree, const Range& range, std::size_t depth) {
    if (range.size() <= leaf_size_) return add_leaf(tree, range);
    const std::vector<Range> parts = children(range, depth);
    const std::size_t place = tree.nodes_.size();
    tree.nodes_.push_back(empty_node());

    // Trees of their own, put together in order: the same for any number of threads.
    std::array<std::future<Hierarchy>, lane_count> grown;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].size() >= thread_size)
            grown[i] = std::async([&, i] {
                Hierarchy part;
                part.root_ = grow_tree(part, parts[i], depth + 1);
                return part;
            });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t child =
            grown[i].valid() ? append(tree, grown[i].get()) : grow_tree(tree, parts[i], depth + 1);
        set_child(tree.nodes_[place], i, parts[i].bounds, child);
    }
    return std::uint32_t(place);
}

Hierarchy HierarchyBuilder::build() {
    Hierarchy tree;
    if (boxes_.empty()) return tree;
    const Range all = measured(0, boxes_.size());
    tree.bounds_ = narrowed(all.bounds);
    const Real largest = largest_coordinate(tree.bounds_);
    scale_ = all_lanes(largest > 0 ? 1 / largest : 1);
    padding_ = all_lanes(4 * unit_roundoff * largest);
    tree.nodes_.reserve(boxes_.size() / 2);
    tree.root_ = grow_tree(tree, all, 0);
    return tree;
}

Hierarchy::Hierarchy(std::span<const Box> boxes, Leaves leaves) {
    *this = HierarchyBuilder(boxes, leaves).build();
}

SlabTest::SlabTest(const Ray& ray, const Box& all, Real min) : min_(all_lanes(min)) {
    const Real reach =
        largest_coordinate({.min = all.min - ray.origin, .max = all.max - ray.origin});
    const Real slack = rounding_of_shapes * unit_roundoff * reach;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const Real inverse = 1 / ray.direction[axis];
        const Real forward = std::copysign(slack, inverse);
        const auto i = std::size_t(axis);
        near_origin_[i] = all_lanes(ray.origin[axis] + forward);
        far_origin_[i] = all_lanes(ray.origin[axis] - forward);
        inverse_[i] = all_lanes(inverse);
        near_row_[i] = 2 * i + (inverse < 0 ? 1 : 0);
    }
}

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
