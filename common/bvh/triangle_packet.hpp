// Watertight intersection test of several triangles at once, in SIMD lanes.
#pragma once

#include "common/bvh/node_intersector.hpp"
#include "common/geometry/ray.hpp"
#include "common/math/compensated.hpp"
#include "common/math/simd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

/// Triangles, one in each lane. NaN in the unused lanes makes them miss. `Number` is float, in
/// either precision, if no coordinate requires more: the packet is half as large, and rays wait
/// less for the memory.
template <class Number>
struct TrianglePacket {
    /// x, y and z of each vertex
    std::array<std::array<LanesOf<Number, real_count>, 3>, 3> vertices;
};

/// The same triangles as Real.
template <class Number>
[[nodiscard]] inline TrianglePacket<Real> real_of(const TrianglePacket<Number>& packet) {
    TrianglePacket<Real> result;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.vertices[vertex][axis] = real_of(packet.vertices[vertex][axis]);
    return result;
}

/// The intersections of a ray with the planes of the triangles of a packet.
struct Crossings {
    std::array<RealN, 3> areas;  ///< area opposite to each vertex, in the projection along the ray
    RealN t;
    unsigned hits;  ///< one bit for each triangle that is hit
};

/// Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", for a packet.
///
/// The coordinate system is changed so that the ray is the z axis, and a shared vertex gets the
/// same bits in each triangle. Then the sign of an area is never wrong, because rounding preserves
/// the order of the two products whose difference it is: at worst the area is 0, which counts as
/// inside. So a ray through a shared edge or vertex hits at least one of the triangles. This does
/// not require fma, which is a function call on some processors, but it requires -ffp-contract=off.
class WatertightTest {
public:
    explicit WatertightTest(const Ray& ray) : WatertightTest(ray, RaySlopes(ray.direction)) {}

    [[gnu::always_inline]] WatertightTest(const Ray& ray, const RaySlopes& slopes)
        : x_(next[slopes.longest]), y_(next[x_]), z_(slopes.longest) {
        const std::array origin = {ray.origin.x, ray.origin.y, ray.origin.z};
        origin_x_ = all(origin[x_]);
        origin_y_ = all(origin[y_]);
        origin_z_ = all(origin[z_]);
        const Real forward = slopes.of_axes[z_];  // 1 or -1
        shear_x_ = all(forward * slopes.of_axes[x_]);
        shear_y_ = all(forward * slopes.of_axes[y_]);
        inverse_z_ = all(forward * slopes.of_axes[3]);
    }

    /// Returns the triangles that the ray hits behind interval.min and not behind interval.max,
    /// edges and vertices included.
    template <class Number>
    [[nodiscard, gnu::always_inline]] Crossings operator()(const TrianglePacket<Number>& packet,
                                                           const Interval& interval) const {
        const Sheared a = sheared(packet.vertices[0]);
        const Sheared b = sheared(packet.vertices[1]);
        const Sheared c = sheared(packet.vertices[2]);
        // One by one: g++ would copy an array of them in parts that it stores and loads again.
        const RealN alpha = area(b, c);
        const RealN beta = area(c, a);
        const RealN gamma = area(a, b);
        const RealN t =
            (alpha * a.z + beta * b.z + gamma * c.z) / (alpha + beta + gamma) * inverse_z_;
        // NaN must miss: t is NaN if an area is NaN, or if all three are 0.
        const auto inside = (all(interval.min) < t) & (t <= all(interval.max));
        return {.areas = {alpha, beta, gamma},
                .t = t,
                .hits = mask_bits(surrounds(alpha, beta, gamma) & inside)};
    }

    /// The same, but the triangles in the lanes of `chosen` are tested one after the other as in
    /// stage 5: with areas of 1.5 ulp, which are products of lengths in units of the triangle's own
    /// size. So they neither cancel, however narrow the triangle is, nor underflow. The ray is
    /// prepared again: a reference to one that is would keep it in memory for the other packets.
    template <class Number>
    [[nodiscard, gnu::noinline]] static Crossings carefully(const Ray& ray,
                                                            const TrianglePacket<Number>& packet,
                                                            Interval interval, unsigned chosen) {
        const WatertightTest test(ray);
        Crossings found = test(packet, interval);
        const Sheared a = test.sheared(packet.vertices[0]);
        const Sheared b = test.sheared(packet.vertices[1]);
        const Sheared c = test.sheared(packet.vertices[2]);
        found.hits &= ~chosen;
        // A rounded area may be 0, but has no wrong sign: no other lane is hit.
        for (unsigned left = chosen & mask_bits(surrounds(area(b, c), area(c, a), area(a, b)));
             left != 0;) {
            const std::size_t i = pop_lowest_bit(left);
            const auto corner = [i](const Sheared& seen) {
                return Vec3(lane(seen.x, i), lane(seen.y, i), lane(seen.z, i));
            };
            const auto [areas, depth] = crossing(corner(a), corner(b), corner(c));
            const Real t = depth * lane(test.inverse_z_, i);
            for (glm::length_t k = 0; k < 3; ++k) set_lane(found.areas[k], i, areas[k]);
            set_lane(found.t, i, t);
            if (interval.min < t && t <= interval.max) found.hits |= 1U << i;
        }
        return found;
    }

private:
    static constexpr std::array<std::size_t, 3> next = {1, 2, 0};

    [[nodiscard, gnu::always_inline]] static RealN all(Real value) {
        return all_of<Real, real_count>(value);
    }

    struct Sheared {
        RealN x;
        RealN y;
        RealN z;
    };

    template <class Number>
    [[nodiscard, gnu::always_inline]] Sheared sheared(
        const std::array<LanesOf<Number, real_count>, 3>& vertex) const {
        Sheared result;
        result.z = real_of(vertex[z_]) - origin_z_;
        result.x = real_of(vertex[x_]) - origin_x_ - shear_x_ * result.z;
        result.y = real_of(vertex[y_]) - origin_y_ - shear_y_ * result.z;
        return result;
    }

    /// Twice the area of the ray's point and two corners.
    [[nodiscard, gnu::always_inline]] static RealN area(const Sheared& p, const Sheared& q) {
        return p.x * q.y - p.y * q.x;
    }

    /// The triangles around the ray, or with it on an edge.
    [[nodiscard, gnu::always_inline]] static MaskOf<Real, real_count> surrounds(RealN alpha,
                                                                                RealN beta,
                                                                                RealN gamma) {
        const RealN zero = all(0);
        return (zero <= min(min(alpha, beta), gamma)) | (max(max(alpha, beta), gamma) <= zero);
    }

    /// The areas opposite to three sheared corners, and the depth at which the ray meets their
    /// plane; a depth of NaN if it passes beside them.
    struct Crossing {
        Vec3 areas;
        Real depth;
    };

    [[nodiscard]] static Crossing crossing(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto reach = [](const Vec3& seen) {
            return std::max(std::abs(seen.x), std::abs(seen.y));
        };
        const Real unit_length = power_of_two_below(std::max({reach(a), reach(b), reach(c)}));
        const auto area = [unit_length](const Vec3& p, const Vec3& q) {
            return difference_of_products(p.x / unit_length, q.y / unit_length, p.y / unit_length,
                                          q.x / unit_length);
        };
        const Vec3 areas(area(b, c), area(c, a), area(a, b));
        const bool left = std::min({areas.x, areas.y, areas.z}) >= 0;
        const bool right = std::max({areas.x, areas.y, areas.z}) <= 0;
        if (!left && !right)
            return {.areas = areas, .depth = std::numeric_limits<Real>::quiet_NaN()};
        return {.areas = areas,
                .depth = a.z + (areas.y * (b.z - a.z) + areas.z * (c.z - a.z)) /
                                   (areas.x + areas.y + areas.z)};
    }

    std::size_t x_;
    std::size_t y_;
    std::size_t z_;  ///< the axis along which the direction is longest
    RealN origin_x_;
    RealN origin_y_;
    RealN origin_z_;
    RealN shear_x_;
    RealN shear_y_;
    RealN inverse_z_;
};

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
