// Which of eight boxes a ray meets, asked of all of them together.
#pragma once

#include "common/ray.hpp"
#include "common/wide.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// Eight boxes and what is in each: a node, or with the leaf bit a leaf. A box not used is empty.
/// Eight as twice four: half as many nodes one after the other, each of which waits for the last,
/// are worth up to a quarter even where vectors have only four lanes.
struct alignas(64) Node {
    static constexpr std::size_t width = 2 * lane_count;
    static constexpr std::uint32_t leaf_bit = std::uint32_t(1) << 31;

    using Row = std::array<Lanes, 2>;

    std::array<Row, 6> planes;  ///< smallest x, largest x, smallest y, …
    std::array<std::uint32_t, width> children;
};

/// A ray, ready to be asked which of a node's boxes it meets. No box that it meets is lost, nor any
/// with a shape that the shape's own rounded test would say it meets (Ize 2013, "Robust BVH Ray
/// Traversal"; Woop, Benthin, Wald 2013, §4).
class SlabTest {
public:
    /// `reach` is how far any box is at most from the ray's origin, along any axis.
    SlabTest(const Ray& ray, Real reach, Real min)
        : min_(all_lanes(min)),
          x_(0, ray.origin.x, ray.direction.x, reach),
          y_(1, ray.origin.y, ray.direction.y, reach),
          z_(2, ray.origin.z, ray.direction.z, reach) {}

    struct Answer {
        Node::Row near;  ///< the t at which the ray enters each box
        unsigned hits;   ///< one bit a box
    };

    /// The boxes that the ray enters before limit, which is finite.
    [[nodiscard, gnu::always_inline]] Answer operator()(const Node& node, Real limit) const {
        const Lanes latest = all_lanes(limit);
        const Node::Row near = {entry(node, 0), entry(node, 1)};
        return {.near = near,
                .hits = bits(near[0] <= exit(node, 0, latest)) |
                        bits(near[1] <= exit(node, 1, latest)) << lane_count};
    }

    /// A finite t before which the ray enters every box that it meets inside the interval. Finite,
    /// as a ray beside a box and parallel to it enters the box at infinity.
    [[nodiscard]] static Real limit(const Interval& interval) {
        return std::min(interval.max * padding, std::numeric_limits<Real>::max());
    }

private:
    /// A slab's t has three roundings, at its far end four: 1 + γ₃ + γ₄ (Ize 2013, §2).
    static constexpr Real padding = 1 + 8 * unit_roundoff;
    /// How far the rounded test of a shape may move a ray, relative to its reach: 8 u for the
    /// watertight triangle, at most 4 u for the others.
    static constexpr Real slack = 16 * unit_roundoff;

    /// The ray along one axis.
    struct Axis {
        Lanes near_origin;
        Lanes far_origin;
        Lanes near_inverse;  ///< of the direction
        Lanes far_inverse;   ///< the same, padded
        std::size_t near_plane;
        std::size_t far_plane;

        [[gnu::always_inline]] Axis(std::size_t axis, Real origin, Real direction, Real reach) {
            const Real inverse = 1 / direction;
            const Real forward = std::copysign(slack * reach, inverse);
            near_origin = all_lanes(origin + forward);
            far_origin = all_lanes(origin - forward);
            near_inverse = all_lanes(inverse);
            far_inverse = all_lanes(inverse * padding);
            const auto backward = std::size_t(std::signbit(inverse));
            near_plane = (2 * axis + backward) * sizeof(Node::Row);
            far_plane = (2 * axis + 1 - backward) * sizeof(Node::Row);
        }

        [[nodiscard, gnu::always_inline]] Lanes near(const Node& node, std::size_t half) const {
            return (plane(node, near_plane, half) - near_origin) * near_inverse;
        }

        [[nodiscard, gnu::always_inline]] Lanes far(const Node& node, std::size_t half) const {
            return (plane(node, far_plane, half) - far_origin) * far_inverse;
        }
    };

    /// A row by its place in bytes: making that from an index would take as long as the test.
    [[nodiscard, gnu::always_inline]] static Lanes plane(const Node& node, std::size_t row,
                                                         std::size_t half) {
        Lanes lanes;
        std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&node) + row + half * sizeof(Lanes),
                    sizeof lanes);
        return lanes;
    }

    // Where the ray runs in a box's face, 0 · ∞ is NaN: in this order it only drops a condition.

    [[nodiscard, gnu::always_inline]] Lanes entry(const Node& node, std::size_t half) const {
        return max(max(x_.near(node, half), y_.near(node, half)), max(z_.near(node, half), min_));
    }

    [[nodiscard, gnu::always_inline]] Lanes exit(const Node& node, std::size_t half,
                                                 Lanes latest) const {
        return min(min(x_.far(node, half), y_.far(node, half)), min(z_.far(node, half), latest));
    }

    Lanes min_;
    Axis x_;
    Axis y_;
    Axis z_;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
