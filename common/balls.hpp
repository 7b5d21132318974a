// Balls around a few shapes, four of which are asked at a time whether a ray comes near: where a
// hierarchy does not pay yet, most shapes are left out by them.
#pragma once

#include "common/ball.hpp"
#include "common/ray.hpp"
#include "common/vector.hpp"
#include "common/wide.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// Four balls, a lane each.
struct BallPacket {
    std::array<Lanes, 3> center;  ///< x, y and z
    Lanes radius_squared;
};

/// A ray, ready to be asked from which balls its line stays away. It stays away from no ball that
/// has a shape which it meets, or would meet by the shape's own rounded test.
///
/// With f from the centre to the origin, the line is further off than the radius r if
/// ⟨f, f⟩⟨d, d⟩ > ⟨f, d⟩² + r²⟨d, d⟩. Of the first product all roundings here are less than 32 u;
/// and if a shape's test is wrong by 16 u |f| beyond what the ball is padded for, that is 32 u of
/// it, as |f| > r. Where a number leaves the range in which this holds, all balls are near.
class BallTest {
public:
    explicit BallTest(const Ray& ray) {
        const auto& [o, d] = ray;
        origin_ = {all_lanes(o.x), all_lanes(o.y), all_lanes(o.z)};
        direction_ = {all_lanes(d.x), all_lanes(d.y), all_lanes(d.z)};
        Real square = glm::dot(d, d);
        if (!keeps_its_digits(square)) square = 0;  // then nothing is greater
        square_ = all_lanes(square);
        padded_square_ = all_lanes(square * (1 - 96 * unit_roundoff));
    }

    /// One bit a ball.
    [[nodiscard, gnu::always_inline]] unsigned stays_away(const BallPacket& packet) const {
        const Lanes x = origin_[0] - packet.center[0];
        const Lanes y = origin_[1] - packet.center[1];
        const Lanes z = origin_[2] - packet.center[2];
        const Lanes along = x * direction_[0] + y * direction_[1] + z * direction_[2];
        const Lanes off = (x * x + y * y + z * z) * padded_square_;
        const Lanes near = along * along + packet.radius_squared * square_;
        return bits((near + all_lanes(smallest) < off) & (off < all_lanes(infinity)));
    }

private:
    /// What underflows is far less than u of this.
    static constexpr Real smallest = std::numeric_limits<Real>::min() / unit_roundoff;

    std::array<Lanes, 3> origin_;
    std::array<Lanes, 3> direction_;
    Lanes square_;  ///< of the direction's length
    Lanes padded_square_;
};

/// Up to 64 balls, by their place in a list.
class Balls {
public:
    static constexpr std::size_t most = 64;

    Balls() = default;
    explicit Balls(std::span<const Ball> balls);

    [[nodiscard]] bool empty() const { return packets_.empty(); }

    [[nodiscard]] Ball operator[](std::size_t i) const {
        const auto& [center, radius_squared] = packets_[i / lane_count];
        const std::size_t lane = i % lane_count;
        return {
            .center = {values(center[0])[lane], values(center[1])[lane], values(center[2])[lane]},
            .radius = std::sqrt(values(radius_squared)[lane])};
    }

    /// A bit for each ball that the ray may meet.
    [[nodiscard]] std::uint64_t near(const Ray& ray) const {
        const BallTest test(ray);
        std::uint64_t away = 0;
        unsigned first = 0;
        for (const BallPacket& packet : packets_) {
            away |= std::uint64_t(test.stays_away(packet)) << first;
            first += lane_count;
        }
        return all_ & ~away;
    }

private:
    std::vector<BallPacket> packets_;
    std::uint64_t all_ = 0;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
