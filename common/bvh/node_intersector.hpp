// The test of a ray against the eight boxes of a node, in SIMD lanes.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/simd.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

/// The coordinate system of the boxes: all of them lie between -1 and 1 along every axis. In this
/// range floats are sufficient, and a register contains twice as many floats as doubles.
struct UnitSpace {
    Vec3 center;
    Real scale = 1;  ///< a power of two, so that scaling is exact

    friend bool operator==(const UnitSpace& a, const UnitSpace& b) = default;
};

/// Eight boxes and their children: the index of a node, or of a leaf if the leaf bit is set. An
/// unused box is empty. The width is eight even where vectors have only four lanes: it halves the
/// number of dependent node visits, which is up to a quarter faster even there.
struct alignas(64) Node {
    static constexpr std::size_t width = 8;
    static constexpr std::uint32_t leaf_bit = std::uint32_t(1) << 31;

    using Row = std::array<FloatN, width / float_count>;

    std::array<Row, 6>
        planes;  ///< in the frame's coordinates: smallest x, largest x, smallest y, …
    std::array<std::uint32_t, width> children;
};

/// A ray prepared for tests against the boxes of nodes. The test is conservative: it never misses a
/// box that the ray hits, nor the box of a shape that the shape's own rounded test would report as
/// hit (Ize 2013, "Robust BVH Ray Traversal"; Woop, Benthin, Wald 2013, §4).
///
/// The ray starts from a point on it near the boxes, and its direction is scaled to a largest
/// component of 1: then times are distances, and the float rounding errors are known in advance.
/// Let D be the distance of the ray's origin from the frame's center, along the axis along which it
/// is largest. A ray that hits [-1, 1]³ does so after D - 1 at the earliest and D + 1 at the
/// latest, because along no axis is it faster than along that of the direction's largest component.
/// So at D - 2 at most 3 remain, and the ray is within 4 of the center; if it is not, it hits
/// nothing.
class RayBoxTest {
public:
    RayBoxTest(const Ray& ray, const UnitSpace& frame) {
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
        // At a lower speed, the errors of components rounded to multiples of the smallest number
        // add up.
        constexpr Real slowest = std::numeric_limits<Real>::denorm_min() / unit_roundoff;
        is_reliable_ = real_slack <= 1 && slowest <= speed_ && speed_ < infinity;
        if (std::isnan(origin.x + origin.y + origin.z + direction.x + direction.y + direction.z))
            is_reliable_ = passes_by_ = true;  // NaN must be a miss
        x_ = Axis(0, place.x, size / direction.x, slack_);
        y_ = Axis(1, place.y, size / direction.y, slack_);
        z_ = Axis(2, place.z, size / direction.z, slack_);
    }

    /// Returns whether the test is reliable. It is not for an origin so far away that all boxes are
    /// within rounding error of each other, nor for an infinite number.
    [[nodiscard]] bool is_reliable() const { return is_reliable_; }

    /// Returns whether the ray misses all boxes of every node.
    [[nodiscard]] bool misses_all() const { return passes_by_; }

    struct Answer {
        Node::Row near;     ///< distance at which the ray enters each box
        unsigned hits = 0;  ///< one bit for each box
    };

    /// Returns the boxes that the ray enters before `limit`.
    [[nodiscard, gnu::always_inline]] Answer operator()(const Node& node, float limit) const {
        const FloatN latest = all(limit);
        Answer answer;
        for (std::size_t part = 0; part < answer.near.size(); ++part) {
            answer.near[part] = entry(node, part);
            answer.hits |= mask_bits(answer.near[part] <= exit(node, part, latest))
                           << (part * float_count);
        }
        return answer;
    }

    /// The distance before which the ray enters every box that it hits before t = max. It is
    /// finite, because a ray that is parallel to a box and beside it enters the box at infinity.
    [[nodiscard]] float limit(Real max) const {
        // In this order the result is not NaN.
        return float(std::min(Real(8), (max - start_) * speed_)) * padding + slack_;
    }

private:
    /// The displacement of a ray, relative to D + 1: by the rounded test of a shape, 17 u, which is
    /// the 34 u L of docs/reference/error_bounds.md for differences of D + 1 in place of 2 L; and
    /// by the change of its start, 5 u.
    static constexpr Real rounding = 32 * unit_roundoff;
    static constexpr float float_roundoff = 0x1p-24F;
    /// The start of a ray is at most 6 from the center and is rounded twice, by 4 u each time;
    /// boxes have an error of 2 u.
    static constexpr float float_slack = 16 * float_roundoff;
    /// The time at a slab has four roundings, and one more where the ray leaves: 1 + γ₄ + γ₅ (Ize
    /// 2013, §2).
    static constexpr float padding = 1 + 12 * float_roundoff;

    [[nodiscard, gnu::always_inline]] static FloatN all(float value) {
        return all_of<float, float_count>(value);
    }

    /// The ray's coordinates along one axis.
    struct Axis {
        FloatN near_origin;
        FloatN far_origin;
        FloatN near_inverse;  ///< inverse of the direction's component
        FloatN far_inverse;   ///< the same inverse, padded
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

        [[nodiscard, gnu::always_inline]] FloatN near(const Node& node, std::size_t part) const {
            return (plane(node, near_plane, part) - near_origin) * near_inverse;
        }

        [[nodiscard, gnu::always_inline]] FloatN far(const Node& node, std::size_t part) const {
            return (plane(node, far_plane, part) - far_origin) * far_inverse;
        }
    };

    /// A row at its offset in bytes: computing the offset from an index would take as long as the
    /// test.
    [[nodiscard, gnu::always_inline]] static FloatN plane(const Node& node, std::size_t row,
                                                          std::size_t part) {
        FloatN lanes;
        std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&node) + row + part * sizeof lanes,
                    sizeof lanes);
        return lanes;
    }

    // If the ray runs in a face of a box, 0 · ∞ is NaN: in this order of operands NaN only drops a
    // condition.

    [[nodiscard, gnu::always_inline]] FloatN entry(const Node& node, std::size_t part) const {
        return max(max(x_.near(node, part), y_.near(node, part)), max(z_.near(node, part), all(0)));
    }

    [[nodiscard, gnu::always_inline]] FloatN exit(const Node& node, std::size_t part,
                                                  FloatN latest) const {
        return min(min(x_.far(node, part), y_.far(node, part)), min(z_.far(node, part), latest));
    }

    Real start_ = 0;  ///< t of the start
    Real speed_;      ///< increase of distance for each unit of t
    float slack_;     ///< upper bound on the error of the ray's position
    bool is_reliable_;
    bool passes_by_ = false;
    Axis x_;
    Axis y_;
    Axis z_;
};

/// A ray prepared for several hierarchies: prepared for the first one, and again only when the
/// frame differs. The ray must outlive it.
class RayBoxTestCache {
public:
    explicit RayBoxTestCache(const Ray& ray) : ray_(ray) {}

    [[nodiscard]] const Ray& ray() const { return ray_; }

    [[nodiscard]] const RayBoxTest& in(const UnitSpace& frame) {
        if (!made_ || made_->frame != frame) made_.emplace(ray_, frame);
        return made_->test;
    }

private:
    struct Made {
        Made(const Ray& ray, const UnitSpace& its_frame) : frame(its_frame), test(ray, its_frame) {}

        UnitSpace frame;
        RayBoxTest test;
    };

    const Ray& ray_;
    std::optional<Made> made_;
};

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
