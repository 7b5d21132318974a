#include "common/bvh/bvh.hpp"

#include "common/bvh/binned_sah.hpp"
#include "common/system/huge_pages.hpp"

#include <future>
#include <memory>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

/// A range of boxes, split in two until it is a leaf: a node of the binary tree. It is stored
/// before the lower part, and that before the upper one.
struct BinaryNode {
    std::array<float, 6> planes;  ///< as in Node
    std::uint32_t begin;
    std::uint32_t to_upper;  ///< distance in memory from this node to its upper part; 0 if a leaf
    std::uint8_t leaf_size;  ///< number of boxes, if a leaf
    /// If the range is to be covered by at most i + 2 nodes, the number of them for the lower part;
    /// 0 if it is covered by one node of its own, or is a leaf.
    std::array<std::uint8_t, Node::width - 1> lower_share;
};

/// The sum of the surface areas of all nodes in a range, which is the expected number of visits, if
/// the range is covered by at most i nodes: the least sum of all choices.
using NodeAreas = std::array<float, Node::width + 1>;

namespace {

/// From this depth on, ranges are split at their middle index. Each then contains half of the boxes
/// of the one around it, so that no arrangement of boxes makes the tree deeper than Bvh::max_depth.
constexpr std::size_t halving_depth = 64;

/// Up to this depth, and from this size on, the upper part of a range is split by another thread.
constexpr std::size_t thread_depth = 3;
constexpr std::size_t thread_size = 65536;

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

/// Chooses the shares of a node by the areas of the nodes in its parts.
NodeAreas choose(BinaryNode& node, float area, const NodeAreas& lower, const NodeAreas& upper) {
    NodeAreas areas{};
    for (std::size_t count = Node::width; count > 1; --count) {
        // The first share in any case: the areas of unbounded boxes are NaN.
        for (std::size_t share = 1; share < count; ++share) {
            const float sum = lower[share] + upper[count - share];
            if (share > 1 && !(sum < areas[count])) continue;
            areas[count] = sum;
            node.lower_share[count - 2] = std::uint8_t(share);
        }
        if (count == Node::width) areas[1] = area + areas[count];
        if (count == Node::width || !(areas[1] <= areas[count])) continue;
        areas[count] = areas[1];
        node.lower_share[count - 2] = 0;
    }
    return areas;
}

/// Appends the at most `places` nodes and leaves that cover the range of `node`.
void collect(std::vector<const BinaryNode*>& children, const BinaryNode& node, std::size_t places) {
    const std::size_t share = places > 1 ? node.lower_share[places - 2] : 0;
    if (share == 0) return children.push_back(&node);
    collect(children, *(&node + 1), share);
    collect(children, *(&node + node.to_upper), places - share);
}

}  // namespace

/// Splits the boxes into a binary tree, and collapses it into the nodes of least area (Ylitie,
/// Karras, Laine 2017, "Efficient Incoherent Ray Traversal … Through Compressed Wide BVHs", §3.1).
class BvhBuilder {
public:
    BvhBuilder(std::size_t count, const BoxOf& box, Bvh::Leaves leaves, const BoundingBox& scene)
        : leaf_size_(leaves == Bvh::Leaves::packed ? std::uint32_t(real_count) : 1),
          bounds_(around(count, box)),
          frame_(frame_for(bounds_, scene)),
          ranges_(in_frame(count, box, frame_, padding_for(bounds_)), leaf_size_) {}

    [[nodiscard]] Bvh tree();

private:
    /// The binary tree of a range.
    struct Part {
        std::size_t end;  ///< the place in nodes_ behind its last node
        std::size_t leaves;
        NodeAreas areas;
    };

    [[nodiscard]] Part split(std::size_t place, const PrimitiveRange& range, std::size_t depth);
    [[nodiscard]] std::uint32_t add(Bvh& tree, const BinaryNode& node) const;

    std::uint32_t leaf_size_;
    BoundingBox bounds_;
    UnitSpace frame_;
    BinnedSah ranges_;
    /// Room for twice as many nodes as boxes. What no node is stored in remains address space.
    std::unique_ptr<BinaryNode[]> nodes_;
};

Bvh BvhBuilder::tree() {
    const PrimitiveRange& all = ranges_.all();
    if (all.size() == 0) return {};
    nodes_.reset(new BinaryNode[2 * all.size()]);  // make_unique would write to all of them
    request_huge_pages(nodes_.get(), 2 * all.size() * sizeof(BinaryNode));
    const std::size_t leaves = split(0, all, 0).leaves;
    ranges_.free_boxes();
    Bvh tree;
    tree.bounds_ = bounds_;
    tree.frame_ = frame_;
    reserve_huge(tree.leaves_, leaves);
    reserve_huge(tree.nodes_, leaves / 4);  // most nodes have more than five children
    tree.root_ = add(tree, nodes_[0]);
    return tree;
}

/// Stores the binary tree of the range from `place` on. Large upper parts are split by threads, if
/// the system has any left, behind the room that the lower part may need at most: the result does
/// not depend on the number of threads.
BvhBuilder::Part BvhBuilder::split(std::size_t place, const PrimitiveRange& range,
                                   std::size_t depth) {
    const auto min = values(range.bounds.min);
    const auto max = values(range.bounds.max);
    BinaryNode& node = nodes_[place];
    node = {.planes = {min[0], max[0], min[1], max[1], min[2], max[2]},
            .begin = std::uint32_t(range.begin)};
    if (range.size() <= leaf_size_) {
        node.leaf_size = std::uint8_t(range.size());
        return {.end = place + 1, .leaves = 1};
    }
    const auto [lower, upper] =
        depth < halving_depth ? ranges_.split(range) : ranges_.split_middle(range);
    std::size_t upper_place = place + 2 * lower.size();
    const auto split_upper = [this, &upper_place, &part = upper, depth] {
        return split(upper_place, part, depth + 1);
    };
    std::future<Part> other;
    if (depth <= thread_depth && upper.size() >= thread_size) other = std::async(split_upper);
    const Part low = split(place + 1, lower, depth + 1);
    if (!other.valid()) upper_place = low.end;
    const Part high = other.valid() ? other.get() : split_upper();
    node.to_upper = std::uint32_t(upper_place - place);
    return {.end = high.end,
            .leaves = low.leaves + high.leaves,
            .areas = choose(node, half_area(range.bounds), low.areas, high.areas)};
}

/// Appends the tree of a range, and returns the reference to its root.
std::uint32_t BvhBuilder::add(Bvh& tree, const BinaryNode& node) const {
    if (node.to_upper == 0) {
        tree.leaves_.emplace_back().indices.fill(Leaf::none);
        std::ranges::copy(ranges_.indices().subspan(node.begin, node.leaf_size),
                          tree.leaves_.back().indices.begin());
        return std::uint32_t(tree.leaves_.size() - 1) | Node::leaf_bit;
    }
    std::vector<const BinaryNode*> children;
    children.reserve(Node::width);
    collect(children, node, Node::width);
    std::array<std::array<float, Node::width>, 6> planes;
    for (std::size_t row = 0; row < planes.size(); ++row)
        planes[row].fill(row % 2 == 0 ? Box4::end : -Box4::end);
    std::array<std::uint32_t, Node::width> references;
    references.fill(Node::leaf_bit);  // reached only by a ray that enters every box
    const std::size_t place = tree.nodes_.size();
    tree.nodes_.emplace_back();
    for (std::size_t i = 0; i < children.size(); ++i) {
        for (std::size_t row = 0; row < planes.size(); ++row)
            planes[row][i] = children[i]->planes[row];
        references[i] = add(tree, *children[i]);
    }
    tree.nodes_[place] = {.planes = std::bit_cast<std::array<Node::Row, 6>>(planes),
                          .children = references};
    return std::uint32_t(place);
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
        const Node& node = nodes_[child];
        for (std::size_t i = 0; i < Node::width; ++i) {
            if (std::bit_cast<std::array<float, Node::width>>(node.planes[0])[i] == Box4::end)
                continue;  // an unused box
            parts.push_back({.parent = place, .leaf = {}});
            children.push_back(node.children[i]);
        }
    }
    return parts;
}

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
