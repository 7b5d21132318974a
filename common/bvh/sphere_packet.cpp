#include "common/bvh/sphere_packet.hpp"

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

BoundingSphereSet::BoundingSphereSet(std::span<const BoundingSphere> balls) {
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

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
