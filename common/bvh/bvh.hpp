// A bounding volume hierarchy: the boxes that a ray hits, roughly near to far, found without a test
// of most of them. It stores boxes and their indices, and nothing about the contents of a box.
#pragma once

#include "common/bvh/node_intersector.hpp"
#include "common/geometry/bounding_box.hpp"
#include "common/math/vector.hpp"

#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// The number of shapes of a kind from which a hierarchy is built. Shorter lists use bounding
/// spheres (measured: docs/reference/accuracy.md).
template <class Shape>
inline constexpr std::size_t bvh_pays_from = 32;

inline namespace RT_LANES {

/// What a query asks of a ray: its closest hit, or whether it has any hit.
enum class QueryKind { closest_hit, any_hit };

/// The indices of the boxes whose contents are tested together.
struct Leaf {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    std::array<std::uint32_t, real_count> indices;  ///< filled up with none
};

/// Returns the box of an index 0, 1, …; called on demand, so that the boxes need no memory.
using BoxOf = std::function<BoundingBox(std::size_t)>;

/// The hierarchy: nodes with eight children each, and leaves of one box or of a packet.
class Bvh {
public:
    /// The cost of a leaf: one step for each box or, if packed, for as many as there are lanes.
    enum class Leaves { one_by_one, packed };

    Bvh() = default;
    /// Builds the hierarchy over `count` boxes; `box(i)` is called twice for each. The result does
    /// not depend on the number of threads that build it. The frame is around `scene` and the boxes
    /// or, if the boxes' digits would be lost in it, around the boxes.
    Bvh(std::size_t count, const BoxOf& box, Leaves leaves = Leaves::one_by_one,
        const BoundingBox& scene = {});

    [[nodiscard]] bool empty() const { return leaves_.empty(); }
    [[nodiscard]] BoundingBox bounds() const { return bounds_; }
    [[nodiscard]] std::span<const Leaf> leaves() const { return leaves_; }

    /// One of the boxes in the hierarchy, by what it contains: boxes, or a leaf.
    struct Part {
        std::size_t parent = 0;           ///< the place in parts() of the box around it
        std::optional<std::size_t> leaf;  ///< an index in leaves()
    };
    /// All boxes, for pictures of the hierarchy: first the one around everything, and each behind
    /// its parent.
    [[nodiscard]] std::vector<Part> parts() const;

    /// Calls visit(index) for the boxes that the ray may hit inside the interval, roughly near to
    /// far. A visit that finds a hit lowers interval.max to it, and boxes beyond are skipped.
    template <class Visit>
    void nearest(RayBoxTestCache& ray, const Interval& interval, Visit visit) const {
        visit_boxes<QueryKind::closest_hit>(ray, interval, visit);
    }

    /// Returns whether visit(index) is true for any box that the ray may hit inside the interval;
    /// stops at the first such box.
    template <class Visit>
    bool any(RayBoxTestCache& ray, const Interval& interval, Visit visit) const {
        return visit_boxes<QueryKind::any_hit>(ray, interval, visit);
    }

    /// The ray's test against the boxes of this hierarchy.
    [[nodiscard]] RayBoxTest<true> test_of(const Ray& ray, const RaySlopes& slopes) const {
        return {ray, frame_, slopes};
    }

    /// Calls visit(leaf), with leaf an index in leaves(), for the leaves that the ray may hit
    /// inside the interval, until a call returns true. Returns whether one did. For the closest
    /// hit, the order is roughly near to far, and a visit may lower interval.max; for any hit, it
    /// is that of memory, since sorting takes longer than the visits that it saves. Calls
    /// expect(leaf), if it is given, to prefetch each leaf that will probably be visited.
    template <QueryKind query, class Test, class Visit, class Expect = std::nullptr_t>
    bool visit_leaves(const Test& slabs, const Interval& interval, Visit visit,
                      Expect expect = {}) const;

private:
    friend class BvhBuilder;

    static constexpr std::size_t max_depth = 96;

    template <QueryKind query, class Visit>
    bool visit_boxes(RayBoxTestCache& ray, const Interval& interval, Visit visit) const {
        return visit_leaves<query>(ray.in(frame_), interval, [&](std::size_t leaf) {
            for (const std::uint32_t index : leaves_[leaf].indices) {
                if (index == Leaf::none) break;
                if constexpr (query == QueryKind::closest_hit)
                    visit(index);
                else if (visit(index))
                    return true;
            }
            return false;
        });
    }

    BoundingBox bounds_;
    UnitSpace frame_;
    std::uint32_t root_ = Node::leaf_bit;
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

template <QueryKind query, class Test, class Visit, class Expect>
bool Bvh::visit_leaves(const Test& slabs, const Interval& interval, Visit visit,
                       [[maybe_unused]] Expect expect) const {
    if (empty() || !(interval.min < interval.max)) return false;
    constexpr bool sorts = query == QueryKind::closest_hit;
    // The entries are children, and above the bits of each, if they are sorted, the distance at
    // which the ray enters its box: it is not negative, so that its bits have the same order.
    std::array<std::uint64_t, (Node::width - 1) * max_depth + 1> later;  // large: uninitialized
    std::uint64_t* end = later.data();
    float limit = slabs.limit(interval.max);
    std::uint32_t child = root_;
    for (;;) {
        if ((child & Node::leaf_bit) != 0) {
            const Real before = interval.max;
            if (visit(child & ~Node::leaf_bit)) return true;
            if (sorts && interval.max != before) limit = slabs.limit(interval.max);
        } else {
            const Node& node = nodes_[child];
            const auto answer = slabs(node, limit);
            unsigned hits = answer.hits;
            if (std::has_single_bit(hits)) {  // most often, and there is no time to prefetch it
                child = node.children[pop_lowest_bit(hits)];
                continue;
            }
            const auto next_hit = [&] {
                const std::size_t i = pop_lowest_bit(hits);
                const std::uint32_t hit = node.children[i];
                if constexpr (!std::is_null_pointer_v<Expect>) {
                    if ((hit & Node::leaf_bit) != 0)
                        expect(hit & ~Node::leaf_bit);
                    else
                        prefetch(nodes_[hit]);
                }
                return sorts
                           ? std::uint64_t(std::bit_cast<std::uint32_t>(answer.near[i])) << 32 | hit
                           : hit;
            };
            if constexpr (!sorts) {
                while (hits != 0) *end++ = next_hit();
            } else if (hits != 0) {
                std::uint64_t nearest = next_hit();
                const std::uint64_t* const first = end;
                while (hits != 0) {
                    std::uint64_t other = next_hit();
                    if (other < nearest) std::swap(nearest, other);
                    // Sorted from far to near by insertion: most often there are one or two.
                    std::uint64_t* place = end++;
                    for (; place > first && place[-1] < other; --place) *place = place[-1];
                    *place = other;
                }
                child = std::uint32_t(nearest);
                continue;
            }
        }
        do {
            if (end == later.data()) return false;
            --end;
        } while (sorts && std::bit_cast<float>(std::uint32_t(*end >> 32)) > limit);
        child = std::uint32_t(*end);
    }
}

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
