// The test of a ray against the eight boxes of a node, in SIMD lanes.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/simd.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <bit>
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

/// The slopes of a ray: its direction, scaled to a largest component of 1. They are computed once,
/// for the tests of boxes and of triangles.
struct RaySlopes {
    Real size;                    ///< the largest component's absolute value
    std::size_t longest;          ///< its axis, the first one of equals
    std::array<Real, 4> of_axes;  ///< direction / size, and 1 / size

    [[gnu::always_inline]] explicit RaySlopes(const Vec3& d) {
        const RealX4 lanes = lanes_of<Real>(d.x, d.y, d.z, 1);
        size = largest_component(d);
        // Bit 2 is the last axis, and set in any case: NaN is not equal to itself.
        longest = std::size_t(
            std::countr_zero(4 | mask_bits(broadcast(size) <= max(lanes, broadcast(0) - lanes))));
        of_axes = values(lanes / broadcast(size));
    }
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
/// nothing. Where the processor has fma, `fused` uses it; without, the order is the same on all.
template <bool fused>
class RayBoxTest {
public:
    [[gnu::always_inline]] RayBoxTest(const Ray& ray, const UnitSpace& frame,
                                      const RaySlopes& slopes) {
        const auto& [origin, direction] = ray;
        speed_ = frame.scale * slopes.size;
        Vec3 place = frame.scale * (origin - frame.center);
        const Real distance = largest_component(place);
        if (distance > 2) {
            start_ = (distance - 2) / speed_;
            place += start_ * (frame.scale * direction);
        }
        const Real real_slack = displacement * (distance + 1);
        slack_ = float(real_slack) + float_slack;
        // At a lower speed, the errors of components rounded to multiples of the smallest number
        // add up.
        constexpr Real slowest = std::numeric_limits<Real>::denorm_min() / unit_roundoff;
        constexpr float endless = std::numeric_limits<float>::infinity();
        if (!(real_slack <= 1 && slowest <= speed_ && speed_ < infinity)) [[unlikely]] {
            start_ = 0;
            speed_ = 1;
            slack_ = endless;  // every box is entered at 0
        } else if (distance > 2 && largest_component(place) > 5) {
            slack_ = -endless;  // the ray passes by
        }
        if (std::isnan(origin.x + origin.y + origin.z + direction.x + direction.y + direction.z))
            slack_ = -endless;  // NaN must be a miss
        prepare_axes(lanes_of<float>(float(place.x), float(place.y), float(place.z), 0),
                     lanes_of<float>(float(slopes.of_axes[0]), float(slopes.of_axes[1]),
                                     float(slopes.of_axes[2]), 1));
    }

    struct Answer {
        /// Distance at which the ray enters each box
        alignas(Node::Row) std::array<float, Node::width> near;
        unsigned hits = 0;  ///< one bit for each box
    };

    /// Returns the boxes that the ray enters before `limit`.
    [[nodiscard, gnu::always_inline]] Answer operator()(const Node& node, float limit) const {
        const auto* const bytes = reinterpret_cast<const std::byte*>(&node);
        const FloatN latest = all(limit);
        Answer answer;
        for (std::size_t part = 0; part < std::tuple_size_v<Node::Row>; ++part) {
            const auto time = [&](std::size_t row) {
                const auto& [inverse, starts] = axes_[row / 2];
                FloatN plane;
                std::memcpy(&plane, bytes + (*rows_)[row] + part * sizeof plane, sizeof plane);
                if constexpr (fused) return multiply_add(plane, inverse, starts[row % 2]);
                return plane * inverse + starts[row % 2];
            };
            const FloatN near = max(max(time(0), time(2)), max(time(4), all(0)));
            const FloatN far = min(min(time(1), time(3)), min(time(5), latest));
            std::memcpy(&answer.near[part * float_count], &near, sizeof near);
            answer.hits |= mask_bits(near <= far) << (part * float_count);
        }
        return answer;
    }

    /// The distance before which the ray enters every box that it hits before t = max. It is
    /// finite, because a ray that is parallel to a box and beside it enters the box at infinity.
    [[nodiscard]] float limit(Real max) const {
        // In this order the result is not NaN.
        return float(std::min(Real(8), (max - start_) * speed_)) + slack_;
    }

private:
    /// The displacement of a ray, relative to D + 1: by the rounded test of a shape, 17 u for D >=
    /// 1 and up to 30 u for a start among the shapes (docs/reference/error_bounds.md); and by the
    /// change of the start, 5 u for D > 2, before 2 u D / (D + 1).
    static constexpr Real displacement = 32 * unit_roundoff;
    static constexpr float float_roundoff = 0x1p-24F;
    /// In units of u: the start of a ray is at most 6 from the center and is rounded twice, by 4
    /// each time, its product with the inverse by 6, and the sum with the slack by 6; boxes have an
    /// error of 2, and their product one of 1. The relative error of the other roundings, 4 of the
    /// inverse and of the result, is at most 12 until the ray is past all boxes, after 3; and as
    /// much for the limit.
    static constexpr float float_slack = 48 * float_roundoff;
    /// The largest inverse, so that none is infinite: a ray that is slower along an axis does not
    /// move by u along it.
    static constexpr float largest_inverse = 0x1p60F;

    [[nodiscard, gnu::always_inline]] static FloatN all(float value) {
        return all_of<float, float_count>(value);
    }

    /// The row of planes through which a ray enters along each axis, and that through which it
    /// leaves, as offsets in bytes: computing them from an index would take as long as the test.
    using Rows = std::array<std::size_t, 6>;

    /// The rows for each combination of backward axes.
    static constexpr std::array<Rows, 8> rows_of = [] {
        std::array<Rows, 8> rows{};
        for (std::size_t backward = 0; backward < rows.size(); ++backward)
            for (std::size_t i = 0; i < 6; ++i)
                rows[backward][i] = (i ^ (backward >> (i / 2) & 1)) * sizeof(Node::Row);
        return rows;
    }();

    /// The ray's coordinates along one axis.
    struct Axis {
        FloatN inverse;                ///< of the direction's component
        std::array<FloatN, 2> starts;  ///< times at a plane through 0, less and plus the slack
    };

    /// Computes all axes at once, one in each lane.
    [[gnu::always_inline]] void prepare_axes(Float4 place, Float4 slopes) {
        const Float4 zero = broadcast_float(0);
        const Float4 least = broadcast_float(-largest_inverse);
        const Float4 most = broadcast_float(largest_inverse);
        const Float4 inverse = max(min(broadcast_float(1) / slopes, most), least);
        const Float4 start = zero - place * inverse;
        const Float4 reach = max(inverse, zero - inverse) * broadcast_float(slack_);
        const Float4 near_start = start - reach;
        const Float4 far_start = start + reach;
        rows_ = &rows_of[mask_bits(inverse < zero) & 7];
        const auto axis = [&](std::size_t i) {
            return Axis{.inverse = all(lane(inverse, i)),
                        .starts = {all(lane(near_start, i)), all(lane(far_start, i))}};
        };
        axes_ = {axis(0), axis(1), axis(2)};
    }

    Real start_ = 0;  ///< t of the start
    Real speed_;      ///< increase of distance for each unit of t
    /// Upper bound on the error of the ray's position: infinite if there is none, because the
    /// origin is so far away that all boxes are within rounding error of each other, or a number is
    /// infinite. The negative of that if the ray misses all boxes.
    float slack_;
    const Rows* rows_;
    std::array<Axis, 3> axes_;
};

/// A ray prepared for several hierarchies, whose boxes are found in the same order everywhere:
/// prepared for the first one, and again only when the frame differs. The ray must outlive it.
class RayBoxTestCache {
public:
    explicit RayBoxTestCache(const Ray& ray) : ray_(ray) {}

    [[nodiscard]] const Ray& ray() const { return ray_; }

    [[nodiscard]] const auto& in(const UnitSpace& frame) {
        if (!test_ || frame_ != frame) test_.emplace(ray_, frame, RaySlopes(ray_.direction));
        frame_ = frame;
        return *test_;
    }

private:
    const Ray& ray_;
    UnitSpace frame_;
    std::optional<RayBoxTest<false>> test_;
};

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
