// Which of eight boxes a ray meets, asked of all of them together.
#pragma once

#include "common/ray.hpp"
#include "common/vector.hpp"
#include "common/wide.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// What boxes are measured in: all of them lie between -1 and 1 along every axis. There floats are
/// enough, of which a register holds twice as many as doubles.
struct Frame {
    Vec3 center;
    Real scale = 1;  ///< a power of two, so that it rounds nothing

    friend bool operator==(const Frame& a, const Frame& b) = default;
};

/// Eight boxes and what is in each: a node, or with the leaf bit a leaf. A box not used is empty.
/// Eight, though vectors may have only four lanes: half as many nodes one after the other, each of
/// which waits for the last, are worth up to a quarter even there.
struct alignas(64) Node {
    static constexpr std::size_t width = 8;
    static constexpr std::uint32_t leaf_bit = std::uint32_t(1) << 31;

    using Row = std::array<MoreFloats, width / float_count>;

    std::array<Row, 6> planes;  ///< in the frame: smallest x, largest x, smallest y, …
    std::array<std::uint32_t, width> children;
};

/// A ray, ready to be asked which of a node's boxes it meets. No box that it meets is lost, nor any
/// with a shape that the shape's own rounded test would say it meets (Ize 2013, "Robust BVH Ray
/// Traversal"; Woop, Benthin, Wald 2013, §4).
///
/// The ray is taken from a place on it that is near the boxes, and its direction's largest
/// component made 1: then times are distances, and what a float rounds is known beforehand. Let D
/// be the distance of the ray's origin from the frame's, along the axis along which it is largest.
/// A ray that meets [-1, 1]³ does so after D - 1 at the earliest and D + 1 at the latest, as no
/// axis takes it further than the direction's largest component. So at D - 2 it has 3 to go at
/// most, and is within 4 of the middle; if it is not, it meets nothing.
class SlabTest {
public:
    SlabTest(const Ray& ray, const Frame& frame) {
        const auto& [origin, direction] = ray;
        const Real size = largest_component(direction);
        speed_ = frame.scale * size;
        Vec3 place = frame.scale * (origin - frame.center);
        const Real distance = largest_component(place);
        if (distance > 2) {
            start_ = (distance - 2) / speed_;
            place += start_ * (frame.scale * direction);
            passes_by_ = largest_component(place) > 5;
        }
        const Real real_slack = rounding * (distance + 1);
        slack_ = float(real_slack) + float_slack;
        // Of a slower one, what its components lack as multiples of the smallest number adds up.
        constexpr Real slowest = std::numeric_limits<Real>::denorm_min() / unit_roundoff;
        certain_ = real_slack <= 1 && slowest <= speed_ && speed_ < infinity;
        if (std::isnan(origin.x + origin.y + origin.z + direction.x + direction.y + direction.z))
            certain_ = passes_by_ = true;  // NaN makes a miss
        x_ = Axis(0, place.x, size / direction.x, slack_);
        y_ = Axis(1, place.y, size / direction.y, slack_);
        z_ = Axis(2, place.z, size / direction.z, slack_);
    }

    /// Whether it can tell at all: from so far away that all boxes are within rounding of each
    /// other, it cannot, nor where a number is infinite.
    [[nodiscard]] bool certain() const { return certain_; }

    /// Whether the ray meets none of the boxes, in whichever node.
    [[nodiscard]] bool passes_by() const { return passes_by_; }

    struct Answer {
        Node::Row near;     ///< where the ray enters each box
        unsigned hits = 0;  ///< one bit a box
    };

    /// The boxes that the ray enters before limit.
    [[nodiscard, gnu::always_inline]] Answer operator()(const Node& node, float limit) const {
        const MoreFloats latest = all(limit);
        Answer answer;
        for (std::size_t part = 0; part < answer.near.size(); ++part) {
            answer.near[part] = entry(node, part);
            answer.hits |= bits(answer.near[part] <= exit(node, part, latest))
                           << (part * float_count);
        }
        return answer;
    }

    /// The ray enters every box that it meets before t = max before this. It is finite, as a ray
    /// beside a box and parallel to it enters the box at infinity.
    [[nodiscard]] float limit(Real max) const {
        // In this order not NaN.
        return float(std::min(Real(8), (max - start_) * speed_)) * padding + slack_;
    }

private:
    /// How far, relative to D + 1, a ray is moved by the rounded test of a shape, 8 u for the
    /// watertight triangle and at most 4 u for the others, and by bringing it here, 5 u.
    static constexpr Real rounding = 16 * unit_roundoff;
    static constexpr float float_roundoff = 0x1p-24F;
    /// No place is further than 6 from the middle, and it is rounded twice, by 4 u each time; boxes
    /// are off by 2 u.
    static constexpr float float_slack = 16 * float_roundoff;
    /// A slab's time has four roundings, one more where the ray leaves: 1 + γ₄ + γ₅ (Ize 2013, §2).
    static constexpr float padding = 1 + 12 * float_roundoff;

    [[nodiscard, gnu::always_inline]] static MoreFloats all(float value) {
        return all_of<float, float_count>(value);
    }

    /// The ray along one axis.
    struct Axis {
        MoreFloats near_origin;
        MoreFloats far_origin;
        MoreFloats near_inverse;  ///< of the direction
        MoreFloats far_inverse;   ///< the same, padded
        std::size_t near_plane;
        std::size_t far_plane;

        Axis() = default;

        [[gnu::always_inline]] Axis(std::size_t axis, Real place, Real inverse_direction,
                                    float slack) {
            const auto inverse = float(inverse_direction);
            const float forward = std::copysign(slack, inverse);
            near_origin = all(float(place) + forward);
            far_origin = all(float(place) - forward);
            near_inverse = all(inverse);
            far_inverse = all(inverse * padding);
            const auto backward = std::size_t(std::signbit(inverse));
            near_plane = (2 * axis + backward) * sizeof(Node::Row);
            far_plane = (2 * axis + 1 - backward) * sizeof(Node::Row);
        }

        [[nodiscard, gnu::always_inline]] MoreFloats near(const Node& node,
                                                          std::size_t part) const {
            return (plane(node, near_plane, part) - near_origin) * near_inverse;
        }

        [[nodiscard, gnu::always_inline]] MoreFloats far(const Node& node, std::size_t part) const {
            return (plane(node, far_plane, part) - far_origin) * far_inverse;
        }
    };

    /// A row by its place in bytes: making that from an index would take as long as the test.
    [[nodiscard, gnu::always_inline]] static MoreFloats plane(const Node& node, std::size_t row,
                                                              std::size_t part) {
        MoreFloats lanes;
        std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&node) + row + part * sizeof lanes,
                    sizeof lanes);
        return lanes;
    }

    // Where the ray runs in a box's face, 0 · ∞ is NaN: in this order it only drops a condition.

    [[nodiscard, gnu::always_inline]] MoreFloats entry(const Node& node, std::size_t part) const {
        return max(max(x_.near(node, part), y_.near(node, part)), max(z_.near(node, part), all(0)));
    }

    [[nodiscard, gnu::always_inline]] MoreFloats exit(const Node& node, std::size_t part,
                                                      MoreFloats latest) const {
        return min(min(x_.far(node, part), y_.far(node, part)), min(z_.far(node, part), latest));
    }

    Real start_ = 0;  ///< the t of the place
    Real speed_;      ///< by how much distance grows with t
    float slack_;     ///< how far the ray may be from where it is taken to be
    bool certain_;
    bool passes_by_ = false;
    Axis x_;
    Axis y_;
    Axis z_;
};

/// A ray for several hierarchies: made ready for the first, and kept for those in the same frame.
/// The ray must outlive it.
class SlabTests {
public:
    explicit SlabTests(const Ray& ray) : ray_(ray) {}

    [[nodiscard]] const Ray& ray() const { return ray_; }

    [[nodiscard]] const SlabTest& in(const Frame& frame) {
        if (!made_ || made_->frame != frame) made_.emplace(ray_, frame);
        return made_->test;
    }

private:
    struct Made {
        Made(const Ray& ray, const Frame& its_frame) : frame(its_frame), test(ray, its_frame) {}

        Frame frame;
        SlabTest test;
    };

    const Ray& ray_;
    std::optional<Made> made_;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
