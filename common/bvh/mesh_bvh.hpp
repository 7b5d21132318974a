// Acceleration structure of a mesh: packets of triangles in the leaves of a bounding volume
// hierarchy, with a watertight intersection test.
#pragma once

#include "common/bvh/bvh.hpp"
#include "common/bvh/triangle_packet.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {
inline namespace RT_LANES {

/// The triangles of a mesh, copied: the mesh itself is not used after construction.
class MeshBvh {
public:
    MeshBvh() = default;
    explicit MeshBvh(const Mesh& mesh);

    /// The closest hit strictly inside the interval, or nothing. Of several triangles at the same
    /// t, it is the one with the lowest index. No ray passes between triangles that share an edge
    /// or a vertex, however small they are compared to the mesh.
    [[nodiscard]] std::optional<MeshHit> nearest(const Ray& ray, Interval interval) const;

    /// Returns whether the ray hits the mesh anywhere strictly inside the interval.
    [[nodiscard]] bool occludes(const Ray& ray, Interval interval) const;

    /// The number of boxes, eight in a node, and of triangles, four or eight in a packet, against
    /// which a query tests the ray.
    [[nodiscard]] std::int64_t test_count(const Ray& ray, Interval interval, QueryKind query) const;

    /// The bounding box of all triangles; empty if there are none.
    [[nodiscard]] BoundingBox bounds() const { return bounds_; }

private:
    [[nodiscard]] Ray scaled(const Ray& ray) const {
        return {.origin = scale_ * ray.origin, .direction = ray.direction};
    }

    [[nodiscard]] Interval scaled(Interval interval) const {
        return {.min = scale_ * interval.min, .max = scale_ * interval.max};
    }

    /// Returns use(crossings) for the hits of the ray, for which `test` is, on the triangles of a
    /// leaf, those at interval.max included. A function of them: g++ would copy them otherwise.
    template <class Use>
    [[gnu::always_inline]] bool with_crossings(const Ray& ray, const WatertightTest& test,
                                               std::size_t leaf, const Interval& interval,
                                               Use use) const {
        const auto with = [&](const auto& packet) {
            if (!careful_.empty() && careful_[leaf] != 0) [[unlikely]]
                return use(
                    WatertightTest::carefully(scaled(ray), packet, interval, careful_[leaf]));
            return use(test(packet, interval));
        };
        return has_float_packets() ? with(float_packets_[leaf]) : with(packets_[leaf]);
    }

    /// The packet of a leaf as Real, for one triangle after the other.
    [[nodiscard]] TrianglePacket<Real> packet(std::size_t leaf) const {
        return has_float_packets() ? real_of(float_packets_[leaf]) : packets_[leaf];
    }

    /// Prefetches the packet of a leaf.
    [[gnu::always_inline]] void expect(std::size_t leaf) const {
        has_float_packets() ? prefetch(float_packets_[leaf]) : prefetch(packets_[leaf]);
    }

    [[nodiscard]] bool has_float_packets() const {
        return sizeof(Real) > sizeof(float) && !float_packets_.empty();
    }

    BoundingBox bounds_;
    Real scale_ = 1;  ///< scale of packets and hierarchy: a power of two, so that it is exact
    Bvh hierarchy_;
    std::vector<TrianglePacket<Real>> packets_;  ///< one packet for each leaf
    /// In place of them, if Real is wider than float and every coordinate is a float.
    std::vector<TrianglePacket<float>> float_packets_;
    /// For each leaf, one bit for each triangle whose areas cancel or underflow. Empty if none do.
    std::vector<std::uint8_t> careful_;
};

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
