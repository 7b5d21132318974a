// A bounding volume hierarchy: which of many boxes a ray meets, the near ones first, without asking
// about most of them. It knows boxes and their indices, not what is in them.
//
// Four boxes a node, asked together (Wald, Benthin, Boulos 2008, "Getting Rid of Packets"), are
// about twice as fast as two asked one after the other.
#pragma once

#include "common/box.hpp"
#include "common/ray.hpp"
#include "common/wide.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// Up to four boxes that are asked about together.
struct Leaf {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    std::array<std::uint32_t, lane_count> indices = {none, none, none, none};
};

/// Four boxes and what is in each: a node, or with the leaf bit a leaf. A box not used is empty.
struct alignas(64) Node {
    static constexpr std::uint32_t leaf_bit = std::uint32_t(1) << 31;

    std::array<Lanes, 6> planes;  ///< smallest x, largest x, smallest y, …
    std::array<std::uint32_t, lane_count> children;
};

/// A ray, ready to be asked which of a node's boxes it meets. No box that it meets is lost, nor any
/// with a shape that the shape's own rounded test would say it meets (Ize 2013, "Robust BVH Ray
/// Traversal"; Woop, Benthin, Wald 2013, §4).
class SlabTest {
public:
    /// Whether there is anything to ask: not with a NaN, without a direction or without a t.
    [[nodiscard]] static bool answers(const Ray& ray, const Interval& interval) {
        const Vec3 zero(0);  // times anything finite
        return dot(zero, ray.origin) + dot(zero, ray.direction) == 0 && ray.direction != zero &&
               interval.min < interval.max;
    }

    /// A finite t that no box beyond the interval is entered before.
    [[nodiscard]] static Real limit(Real interval_max) {
        return std::min(interval_max * padding, std::numeric_limits<Real>::max());
    }

    SlabTest(const Ray& ray, const Box& all, Real min);

    struct Answer {
        Lanes near;     ///< the t at which the ray enters each box
        unsigned hits;  ///< one bit a box
    };

    /// The boxes that the ray enters before limit, which is finite.
    [[nodiscard]] Answer operator()(const Node& node, Real limit) const;

private:
    /// The three roundings of a slab's t err by γ₃ either way (Ize 2013, §2).
    static constexpr Real padding = 1 + 8 * unit_roundoff;
    /// How far, in u of the farthest coordinate as the ray's origin sees it, the rounded tests of
    /// shapes may move a ray: 8 for the watertight triangle, at most 4 for the others
    /// (docs/accuracy.md).
    static constexpr Real rounding_of_shapes = 16;

    Lanes min_;
    std::array<Lanes, 3> near_origin_;
    std::array<Lanes, 3> far_origin_;
    std::array<Lanes, 3> inverse_;  ///< of the direction
    std::array<std::size_t, 3> near_row_;
};

/// Takes the lowest bit that is set, and says which it was.
[[nodiscard]] inline std::size_t take_lowest(unsigned& bits) {
    const auto lowest = std::size_t(std::countr_zero(bits));
    bits &= bits - 1;
    return lowest;
}

class Hierarchy {
public:
    /// What it costs to ask about a leaf: as much as about each of its boxes, or, where four of
    /// them are asked together, as about one.
    enum class Leaves { one_by_one, packed };

    Hierarchy() = default;
    explicit Hierarchy(std::span<const Box> boxes, Leaves leaves = Leaves::one_by_one);

    [[nodiscard]] bool empty() const { return leaves_.empty(); }
    [[nodiscard]] Box bounds() const { return bounds_; }
    [[nodiscard]] std::span<const Leaf> leaves() const { return leaves_; }

    /// Calls visit(index) for the boxes that the ray may meet inside the interval, near ones first.
    /// A visit that finds a hit lowers interval.max to it, and boxes beyond are left out.
    template <class Visit>
    void nearest(const Ray& ray, Interval& interval, Visit visit) const;

    /// Whether visit(index) is true for any of the boxes that the ray may meet inside the interval.
    template <class Visit>
    [[nodiscard]] bool any(const Ray& ray, Interval interval, Visit visit) const;

    /// The same for whole leaves: calls visit(place in leaves()) until it is true, and says whether
    /// it was.
    template <class Visit>
    bool visit_leaves(const Ray& ray, const Interval& interval, Visit visit) const;

private:
    friend class HierarchyBuilder;
    static constexpr std::size_t max_depth = 64;

    Box bounds_;
    std::uint32_t root_ = Node::leaf_bit;
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

inline SlabTest::Answer SlabTest::operator()(const Node& node, Real limit) const {
    const auto near = [&](std::size_t axis) {
        return (node.planes[near_row_[axis]] - near_origin_[axis]) * inverse_[axis];
    };
    const auto far = [&](std::size_t axis) {
        return (node.planes[near_row_[axis] ^ 1] - far_origin_[axis]) * inverse_[axis];
    };
    // Where the ray runs in a box's face, 0 · ∞ is NaN. In this order NaN only drops a condition.
    const Lanes entry = max(max(near(0), near(1)), max(near(2), min_));
    const Lanes exit = min(min(min(far(0), far(1)), far(2)) * all_lanes(padding), all_lanes(limit));
    return {.near = entry, .hits = bits(entry <= exit)};
}

template <class Visit>
bool Hierarchy::visit_leaves(const Ray& ray, const Interval& interval, Visit visit) const {
    if (empty() || !SlabTest::answers(ray, interval)) return false;
    const SlabTest slabs(ray, bounds_, interval.min);
    struct Later {
        std::uint32_t child;
        Real near;
    };
    std::array<Later, 3 * max_depth> stack;  // a node leaves at most three of its four for later
    std::size_t waiting = 0;
    Real limit = SlabTest::limit(interval.max);
    std::uint32_t child = root_;
    for (;;) {
        if ((child & Node::leaf_bit) != 0) {
            if (visit(child & ~Node::leaf_bit)) return true;
            limit = SlabTest::limit(interval.max);
        } else {
            const Node& node = nodes_[child];
            const SlabTest::Answer answer = slabs(node, limit);
            if (unsigned hits = answer.hits; hits != 0) {
                const auto near = values(answer.near);
                std::size_t nearest = take_lowest(hits);
                const std::size_t first = waiting;
                while (hits != 0) {
                    std::size_t other = take_lowest(hits);
                    if (near[other] < near[nearest]) std::swap(other, nearest);
                    // The farthest lowest: an insertion sort of at most three.
                    std::size_t place = waiting++;
                    for (; place > first && stack[place - 1].near < near[other]; --place)
                        stack[place] = stack[place - 1];
                    stack[place] = {.child = node.children[other], .near = near[other]};
                }
                child = node.children[nearest];
                continue;
            }
        }
        do {
            if (waiting == 0) return false;
            --waiting;
        } while (stack[waiting].near > limit);
        child = stack[waiting].child;
    }
}

template <class Visit>
void Hierarchy::nearest(const Ray& ray, Interval& interval, Visit visit) const {
    visit_leaves(ray, interval, [&](std::size_t leaf) {
        for (const std::uint32_t index : leaves_[leaf].indices) {
            if (index == Leaf::none) break;
            visit(index);
        }
        return false;
    });
}

template <class Visit>
bool Hierarchy::any(const Ray& ray, Interval interval, Visit visit) const {
    return visit_leaves(ray, interval, [&](std::size_t leaf) {
        for (const std::uint32_t index : leaves_[leaf].indices) {
            if (index == Leaf::none) break;
            if (visit(index)) return true;
        }
        return false;
    });
}

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
