// Watertight intersection test of four triangles at once, in SIMD lanes.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/simd.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

/// Four triangles, one in each lane. NaN in the unused lanes makes them miss. `Number` is float, in
/// either precision, if no coordinate requires more: the packet is half as large, and rays wait
/// less for the memory.
template <class Number>
struct Triangle4 {
    /// x, y and z of each vertex
    std::array<std::array<LanesOf<Number, lane_count>, 3>, 3> vertices;
};

/// The same triangles as Real.
template <class Number>
[[nodiscard]] inline Triangle4<Real> real_of(const Triangle4<Number>& packet) {
    Triangle4<Real> result;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.vertices[vertex][axis] = real_of(packet.vertices[vertex][axis]);
    return result;
}

/// The intersections of a ray with the planes of four triangles.
struct Crossings {
    std::array<RealX4, 3> areas;  ///< area opposite to each vertex, in the projection along the ray
    RealX4 t;
    unsigned hits;  ///< one bit for each triangle that is hit
};

/// Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", for four triangles.
///
/// The coordinate system is changed so that the ray is the z axis, and a shared vertex gets the
/// same bits in each triangle. Then the sign of an area is never wrong, because rounding preserves
/// the order of the two products whose difference it is: at worst the area is 0, which counts as
/// inside. So a ray through a shared edge or vertex hits at least one of the triangles. This does
/// not require fma, which is a function call on some processors, but it requires -ffp-contract=off.
class WatertightTest {
public:
    [[gnu::always_inline]] explicit WatertightTest(const Ray& ray) {
        const auto& [origin, d] = ray;
        const Vec3 size(std::fabs(d.x), std::fabs(d.y), std::fabs(d.z));
        z_ = size.y > size.x ? 1 : 0;
        z_ = size.z > std::max(size.x, size.y) ? 2 : z_;
        x_ = next[z_];
        y_ = next[x_];
        const auto x = glm::length_t(x_);
        const auto y = glm::length_t(y_);
        const auto z = glm::length_t(z_);
        origin_x_ = broadcast(origin[x]);
        origin_y_ = broadcast(origin[y]);
        origin_z_ = broadcast(origin[z]);
        shear_x_ = broadcast(d[x] / d[z]);
        shear_y_ = broadcast(d[y] / d[z]);
        inverse_z_ = broadcast(1 / d[z]);
    }

    /// Returns the triangles that the ray hits strictly inside the interval, edges and vertices
    /// included.
    template <class Number>
    [[nodiscard, gnu::always_inline]] Crossings operator()(const Triangle4<Number>& packet,
                                                           const Interval& interval) const {
        const Sheared a = sheared(packet.vertices[0]);
        const Sheared b = sheared(packet.vertices[1]);
        const Sheared c = sheared(packet.vertices[2]);
        const RealX4 alpha = b.x * c.y - b.y * c.x;
        const RealX4 beta = c.x * a.y - c.y * a.x;
        const RealX4 gamma = a.x * b.y - a.y * b.x;
        const RealX4 zero = broadcast(0);
        const auto left = zero <= min(min(alpha, beta), gamma);
        const auto right = max(max(alpha, beta), gamma) <= zero;
        const RealX4 t =
            (alpha * a.z + beta * b.z + gamma * c.z) / (alpha + beta + gamma) * inverse_z_;
        // NaN must miss: t is NaN if an area is NaN, or if all three are 0.
        const auto inside = (broadcast(interval.min) < t) & (t < broadcast(interval.max));
        return {.areas = {alpha, beta, gamma}, .t = t, .hits = mask_bits((left | right) & inside)};
    }

private:
    static constexpr std::array<std::size_t, 3> next = {1, 2, 0};

    struct Sheared {
        RealX4 x;
        RealX4 y;
        RealX4 z;
    };

    template <class Number>
    [[nodiscard, gnu::always_inline]] Sheared sheared(
        const std::array<LanesOf<Number, lane_count>, 3>& vertex) const {
        const RealX4 z = real_of(vertex[z_]) - origin_z_;
        return {.x = real_of(vertex[x_]) - origin_x_ - shear_x_ * z,
                .y = real_of(vertex[y_]) - origin_y_ - shear_y_ * z,
                .z = z};
    }

    std::size_t x_;
    std::size_t y_;
    std::size_t z_;  ///< the axis along which the direction is longest
    RealX4 origin_x_;
    RealX4 origin_y_;
    RealX4 origin_z_;
    RealX4 shear_x_;
    RealX4 shear_y_;
    RealX4 inverse_z_;
};

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
