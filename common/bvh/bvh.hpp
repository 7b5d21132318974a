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
    /// The cost of a leaf: one step for each box or, if its contents are packed, one step for as
    /// many as there are lanes.
    enum class Leaves { one_by_one, packed };

    Bvh() = default;
    /// Builds the hierarchy over `count` boxes. `box(i)` is called twice for each index instead of
    /// storing the boxes, which would fill the memory. The result does not depend on the number of
    /// threads that build it. The frame is the one around `scene`, if all boxes fit in it and it is
    /// not so large that their digits would be lost; else it is the frame around the boxes.
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
    void nearest(RayBoxTestCache& ray, const Interval& interval, Visit visit) const;

    /// Returns whether visit(index) is true for any box that the ray may hit inside the interval;
    /// stops at the first such box.
    template <class Visit>
    bool any(RayBoxTestCache& ray, const Interval& interval, Visit visit) const;

    /// The ray's test against the boxes of this hierarchy.
    [[nodiscard]] RayBoxTest<true> test_of(const Ray& ray, const RaySlopes& slopes) const {
        return {ray, frame_, slopes};
    }

    /// Calls visit(leaf), with leaf an index in leaves(), for the leaves that the ray may hit
    /// inside the interval, roughly near to far, until a call returns true. Returns whether one
    /// did. A visit may lower interval.max. If `visit` has a function node(), it is called for each
    /// node whose boxes are tested. Calls expect(leaf), if it is given, for each leaf that will
    /// probably be visited: the processor can fetch its content from memory while it tests others.
    template <class Test, class Visit, class Expect = std::nullptr_t>
    bool visit_leaves(const Test& slabs, const Interval& interval, Visit visit,
                      Expect expect = {}) const;

private:
    friend class BvhBuilder;

    static constexpr std::size_t max_depth = 64;

    BoundingBox bounds_;
    UnitSpace frame_;
    std::uint32_t root_ = Node::leaf_bit;
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

template <class Test, class Visit, class Expect>
bool Bvh::visit_leaves(const Test& slabs, const Interval& interval, Visit visit,
                       [[maybe_unused]] Expect expect) const {
    if (empty() || !(interval.min < interval.max)) return false;
    if (!slabs.is_reliable()) {
        for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
            if (visit(leaf)) return true;
        return false;
    }
    if (slabs.misses_all()) return false;
    struct Later {
        std::uint32_t child;
        float near;
    };
    std::array<Later, (Node::width - 1) * max_depth> later;  // left uninitialized: it is large
    std::size_t waiting = 0;
    float limit = slabs.limit(interval.max);
    std::uint32_t child = root_;
    for (;;) {
        if ((child & Node::leaf_bit) != 0) {
            const Real before = interval.max;
            if (visit(child & ~Node::leaf_bit)) return true;
            if (interval.max != before) limit = slabs.limit(interval.max);
        } else {
            const Node& node = nodes_[child];
            if constexpr (requires { visit.node(); }) visit.node();
            const auto answer = slabs(node, limit);
            if (unsigned hits = answer.hits; hits != 0) {
                const auto near = [&](std::size_t i) {
                    return lane(answer.near[i / float_count], i % float_count);
                };
                const auto next_hit = [&] {
                    const std::size_t i = pop_lowest_bit(hits);
                    if constexpr (!std::is_null_pointer_v<Expect>) {
                        const std::uint32_t hit = node.children[i];
                        if ((hit & Node::leaf_bit) != 0)
                            expect(hit & ~Node::leaf_bit);
                        else
                            prefetch(nodes_[hit]);
                    }
                    return i;
                };
                std::size_t nearest = next_hit();
                const std::size_t first = waiting;
                while (hits != 0) {
                    std::size_t other = next_hit();
                    if (near(other) < near(nearest)) std::swap(nearest, other);
                    // Sorted from far to near by insertion: most often there are one or two.
                    std::size_t place = waiting++;
                    for (; place > first && later[place - 1].near < near(other); --place)
                        later[place] = later[place - 1];
                    later[place] = {.child = node.children[other], .near = near(other)};
                }
                child = node.children[nearest];
                continue;
            }
        }
        do {
            if (waiting == 0) return false;
            --waiting;
        } while (later[waiting].near > limit);
        child = later[waiting].child;
    }
}

template <class Visit>
void Bvh::nearest(RayBoxTestCache& ray, const Interval& interval, Visit visit) const {
    any(ray, interval, [&](std::uint32_t index) {
        visit(index);
        return false;
    });
}

template <class Visit>
bool Bvh::any(RayBoxTestCache& ray, const Interval& interval, Visit visit) const {
    return visit_leaves(ray.in(frame_), interval, [&](std::size_t leaf) {
        for (const std::uint32_t index : leaves_[leaf].indices) {
            if (index == Leaf::none) break;
            if (visit(index)) return true;
        }
        return false;
    });
}

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
