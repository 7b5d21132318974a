// Bounding spheres for short lists of shapes. A ray is tested against four spheres at once (in SIMD
// lanes), and only the shapes whose sphere it may hit are intersected.
#pragma once

#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/ray.hpp"
#include "common/math/simd.hpp"
#include "common/math/vector.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

/// Four bounding spheres, one in each SIMD lane.
struct BoundingSphere4 {
    std::array<RealX4, 3> center;  ///< x, y and z
    RealX4 radius_squared;
};

/// A ray prepared for tests against bounding spheres. The test is conservative: it never rejects
/// the sphere of a shape that the line of the ray hits, nor of one that the shape's own rounded
/// test would report as hit.
///
/// With f from the center to the origin, the line is farther from the center than the radius r if
/// ⟨f, f⟩⟨d, d⟩ > ⟨f, d⟩² + r²⟨d, d⟩. All rounding errors here are together less than 32 u of the
/// first product. A shape's own test may be wrong by 34 u |f|, as differences of coordinates are at
/// most |f| + r (docs/reference/error_bounds.md), which is another 68 u of that product, as |f| >
/// r. If a number leaves the range in which these bounds are valid, no sphere is rejected.
class BoundingSphereTest {
public:
    explicit BoundingSphereTest(const Ray& ray) {
        const auto& [o, d] = ray;
        origin_ = {broadcast(o.x), broadcast(o.y), broadcast(o.z)};
        direction_ = {broadcast(d.x), broadcast(d.y), broadcast(d.z)};
        Real square = glm::dot(d, d);
        if (!is_safe_square(square)) square = 0;  // then no comparison is true
        square_ = broadcast(square);
        padded_square_ = broadcast(square * (1 - 128 * unit_roundoff));
    }

    /// Returns one bit for each sphere, set if the line of the ray misses it.
    [[nodiscard, gnu::always_inline]] unsigned certainly_misses(
        const BoundingSphere4& packet) const {
        const RealX4 x = origin_[0] - packet.center[0];
        const RealX4 y = origin_[1] - packet.center[1];
        const RealX4 z = origin_[2] - packet.center[2];
        const RealX4 along = x * direction_[0] + y * direction_[1] + z * direction_[2];
        const RealX4 off = (x * x + y * y + z * z) * padded_square_;
        const RealX4 near = along * along + packet.radius_squared * square_;
        return mask_bits((near + broadcast(smallest) < off) & (off < broadcast(infinity)));
    }

private:
    /// The total of all underflow is far less than u times this number.
    static constexpr Real smallest = std::numeric_limits<Real>::min() / unit_roundoff;

    std::array<RealX4, 3> origin_;
    std::array<RealX4, 3> direction_;
    RealX4 square_;  ///< squared length of the direction
    RealX4 padded_square_;
};

/// Up to 64 bounding spheres, numbered as the shapes in their list.
class BoundingSphereSet {
public:
    static constexpr std::size_t most = 64;

    BoundingSphereSet() = default;
    explicit BoundingSphereSet(std::span<const BoundingSphere> balls) {
        // A smaller square could have a rounding error larger than the test allows for.
        constexpr Real smallest_square =
            std::numeric_limits<Real>::min() / (unit_roundoff * unit_roundoff);
        for (std::size_t first = 0; first < balls.size(); first += lane_count) {
            std::array<std::array<Real, lane_count>, 4> lanes{};
            for (std::size_t i = 0; i < lane_count && first + i < balls.size(); ++i) {
                const auto& [center, radius] = balls[first + i];
                lanes[0][i] = center.x;
                lanes[1][i] = center.y;
                lanes[2][i] = center.z;
                lanes[3][i] = glm::max(radius * radius, smallest_square);
                all_ |= std::uint64_t(1) << (first + i);
            }
            packets_.push_back(std::bit_cast<BoundingSphere4>(lanes));
        }
    }

    [[nodiscard]] bool empty() const { return packets_.empty(); }

    [[nodiscard]] BoundingSphere operator[](std::size_t i) const {
        const auto& [center, radius_squared] = packets_[i / lane_count];
        const std::size_t lane = i % lane_count;
        return {
            .center = {values(center[0])[lane], values(center[1])[lane], values(center[2])[lane]},
            .radius = std::sqrt(values(radius_squared)[lane])};
    }

    /// Returns one bit for each sphere, set if the ray may hit it.
    [[nodiscard]] std::uint64_t candidates(const Ray& ray) const {
        const BoundingSphereTest test(ray);
        std::uint64_t away = 0;
        unsigned first = 0;
        for (const BoundingSphere4& packet : packets_) {
            away |= std::uint64_t(test.certainly_misses(packet)) << first;
            first += lane_count;
        }
        return all_ & ~away;
    }

private:
    std::vector<BoundingSphere4> packets_;
    std::uint64_t all_ = 0;
};

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
