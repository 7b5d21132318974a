#include "common/bvh/bvh.hpp"

#include "common/bvh/binned_sah.hpp"
#include "common/system/huge_pages.hpp"

#include <cstring>
#include <future>

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

namespace {

/// From this depth on, ranges are split at their middle index. Each node then contains at most half
/// of the boxes of its parent, so that no arrangement of boxes makes the tree deeper than
/// Bvh::max_depth.
constexpr std::size_t halving_depth = 32;

/// From this size on, a part of the tree may be built by a separate thread.
constexpr std::size_t thread_size = 65536;

Node empty_node() {
    Node node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        node.planes[2 * axis].fill(all_of<float, float_count>(Box4::end));
        node.planes[2 * axis + 1].fill(all_of<float, float_count>(-Box4::end));
    }
    node.children.fill(Node::leaf_bit);  // reached only through NaN
    return node;
}

/// True if lane i of the node contains a child: a node can have fewer than `width`.
bool has_child(const Node& node, std::size_t i) {
    return std::bit_cast<std::array<float, Node::width>>(node.planes[0])[i] < Box4::end;
}

BoundingBox around(std::size_t count, const BoxOf& box) {
    BoundingBox all;
    for (std::size_t i = 0; i < count; ++i) all = merged(all, box(i));
    return all;
}

/// The extra padding of the boxes for the shapes' tests: where all coordinates are small and near
/// 0, the slack of RayBoxTest is less than the error of those tests.
Real padding_for(const BoundingBox& bounds) {
    return 4 * unit_roundoff * largest_component(bounds);
}

UnitSpace frame_around(const BoundingBox& bounds) {
    const Vec3 half_size = bounds.max / Real(2) - bounds.min / Real(2) + padding_for(bounds);
    const Real largest = largest_component(half_size);
    // With unbounded boxes, NaN makes every RayBoxTest unreliable.
    return {.center = bounds.min / Real(2) + bounds.max / Real(2),
            .scale = largest < infinity ? Real(0.5) / power_of_two_below(largest)
                                        : std::numeric_limits<Real>::quiet_NaN()};
}

/// The scene's frame, unless these boxes are so small in it that rounding to its floats would make
/// them far too wide.
UnitSpace frame_for(const BoundingBox& bounds, const BoundingBox& scene) {
    constexpr Real smallest = Real(1) / 16;
    const UnitSpace own = frame_around(bounds);
    const UnitSpace shared = frame_around(merged(bounds, scene));
    return shared.scale >= smallest * own.scale ? shared : own;
}

/// The boxes in the frame's coordinates. They are not rounded outward: RayBoxTest allows for their
/// rounding errors.
std::vector<Box4> in_frame(std::size_t count, const BoxOf& box, const UnitSpace& frame,
                           Real padding) {
    std::vector<Box4> result;
    reserve_huge(result, count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto [low, high] = box(i);
        const Vec3 min = frame.scale * (low - padding - frame.center);
        const Vec3 max = frame.scale * (high + padding - frame.center);
        result.push_back({.min = lanes_of<float>(float(min.x), float(min.y), float(min.z), 0),
                          .max = lanes_of<float>(float(max.x), float(max.y), float(max.z), 0)});
    }
    return result;
}

}  // namespace

/// Builds the tree from the root down.
class BvhBuilder {
public:
    BvhBuilder(std::size_t count, const BoxOf& box, Bvh::Leaves leaves, const BoundingBox& scene)
        : leaf_size_(leaves == Bvh::Leaves::packed ? std::uint32_t(real_count) : 1),
          bounds_(around(count, box)),
          frame_(frame_for(bounds_, scene)),
          ranges_(in_frame(count, box, frame_, padding_for(bounds_)), leaf_size_) {}

    [[nodiscard]] Bvh tree();

private:
    [[nodiscard]] Bvh with_room_for(const PrimitiveRange& range) const;
    [[nodiscard]] std::uint32_t grow(Bvh& tree, const PrimitiveRange& range, std::size_t depth);
    [[nodiscard]] std::vector<PrimitiveRange> parts(const PrimitiveRange& range, std::size_t depth);
    [[nodiscard]] std::uint32_t add_leaf(Bvh& tree, const PrimitiveRange& range) const;
    [[nodiscard]] static std::uint32_t add(Bvh& tree, const Bvh& part);
    static void set_child(Node& node, std::size_t i, const Box4& box, std::uint32_t child);

    std::uint32_t leaf_size_;
    BoundingBox bounds_;
    UnitSpace frame_;
    BinnedSah ranges_;
};

Bvh BvhBuilder::tree() {
    const PrimitiveRange& all = ranges_.all();
    if (all.size() == 0) return {};
    Bvh tree = with_room_for(all);
    tree.bounds_ = bounds_;
    tree.frame_ = frame_;
    tree.root_ = grow(tree, all, 0);
    return tree;
}

/// An empty tree with reserved memory. Most leaves are full, and most nodes have more than four
/// children.
Bvh BvhBuilder::with_room_for(const PrimitiveRange& range) const {
    Bvh tree;
    const std::size_t leaves = range.size() / leaf_size_ + 1;
    reserve_huge(tree.leaves_, leaves + leaves / 4);
    reserve_huge(tree.nodes_, leaves / 4);
    return tree;
}

/// Appends the subtree of the range, and returns the reference to its root.
std::uint32_t BvhBuilder::grow(Bvh& tree, const PrimitiveRange& range, std::size_t depth) {
    if (range.size() <= leaf_size_) return add_leaf(tree, range);
    const std::vector<PrimitiveRange> children = parts(range, depth);
    const std::size_t place = tree.nodes_.size();
    tree.nodes_.push_back(empty_node());

    // Large parts of the root are built as separate trees and appended in order, so that the result
    // does not depend on the number of threads. If the system has no thread left, they are built
    // here when their result is needed.
    std::array<std::future<Bvh>, Node::width> large;
    for (std::size_t i = 0; i < children.size(); ++i)
        if (depth == 0 && children[i].size() >= thread_size)
            large[i] = std::async([this, &child = children[i], depth] {
                Bvh part = with_room_for(child);
                part.root_ = grow(part, child, depth + 1);
                return part;
            });
    for (std::size_t i = 0; i < children.size(); ++i) {
        const std::uint32_t child =
            large[i].valid() ? add(tree, large[i].get()) : grow(tree, children[i], depth + 1);
        set_child(tree.nodes_[place], i, children[i].bounds, child);
    }
    return std::uint32_t(place);
}

/// Splits a range into up to eight parts: the part with the largest surface is split next.
std::vector<PrimitiveRange> BvhBuilder::parts(const PrimitiveRange& range, std::size_t depth) {
    std::vector<PrimitiveRange> parts = {range};
    parts.reserve(Node::width);
    while (parts.size() < Node::width) {
        PrimitiveRange* widest = nullptr;
        for (PrimitiveRange& part : parts) {
            if (part.size() <= leaf_size_) continue;
            // The area of an unbounded box is NaN, and counts as the largest.
            if (widest == nullptr || !(half_area(part.bounds) <= half_area(widest->bounds)))
                widest = &part;
        }
        if (widest == nullptr) break;
        const auto [lower, upper] =
            depth < halving_depth ? ranges_.split(*widest) : ranges_.split_middle(*widest);
        *widest = lower;
        parts.push_back(upper);
    }
    return parts;
}

std::uint32_t BvhBuilder::add_leaf(Bvh& tree, const PrimitiveRange& range) const {
    Leaf leaf;
    leaf.indices.fill(Leaf::none);
    std::ranges::copy(ranges_.indices().subspan(range.begin, range.size()), leaf.indices.begin());
    tree.leaves_.push_back(leaf);
    return std::uint32_t(tree.leaves_.size() - 1) | Node::leaf_bit;
}

/// Appends a separate tree, and returns the new reference to its root.
std::uint32_t BvhBuilder::add(Bvh& tree, const Bvh& part) {
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

void BvhBuilder::set_child(Node& node, std::size_t i, const Box4& box, std::uint32_t child) {
    const auto min = values(box.min);
    const auto max = values(box.max);
    auto* const lane = reinterpret_cast<std::byte*>(&node) + i * sizeof(float);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(lane + 2 * axis * sizeof(Node::Row), &min[axis], sizeof(float));
        std::memcpy(lane + (2 * axis + 1) * sizeof(Node::Row), &max[axis], sizeof(float));
    }
    node.children[i] = child;
}

Bvh::Bvh(std::size_t count, const BoxOf& box, Leaves leaves, const BoundingBox& scene)
    : Bvh(BvhBuilder(count, box, leaves, scene).tree()) {}

std::vector<Bvh::Part> Bvh::parts() const {
    if (empty()) return {};
    std::vector<std::uint32_t> children = {root_};
    std::vector<Part> parts(1);
    for (std::size_t place = 0; place < parts.size(); ++place) {
        const std::uint32_t child = children[place];
        if ((child & Node::leaf_bit) != 0) {
            parts[place].leaf = child & ~Node::leaf_bit;
            continue;
        }
        for (std::size_t i = 0; i < Node::width; ++i) {
            if (!has_child(nodes_[child], i)) continue;
            parts.push_back({.parent = place, .leaf = {}});
            children.push_back(nodes_[child].children[i]);
        }
    }
    return parts;
}

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
