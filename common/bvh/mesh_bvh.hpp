// Acceleration structure of a mesh: packets of four triangles in the leaves of a bounding volume
// hierarchy, with a watertight intersection test.
#pragma once

#include "common/bvh/bvh.hpp"
#include "common/bvh/triangle_packet.hpp"
#include "common/geometry/mesh.hpp"

#include <optional>

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

/// The triangles of a mesh, copied: the mesh itself is not used after construction.
class MeshBvh {
public:
    MeshBvh() = default;
    explicit MeshBvh(const Mesh& mesh);

    /// The closest hit strictly inside the interval, or nothing. No ray passes between triangles
    /// that share an edge or a vertex, however small they are compared to the mesh.
    [[nodiscard]] std::optional<MeshHit> nearest(const Ray& ray, Interval interval) const;

    /// Returns whether the ray hits the mesh anywhere strictly inside the interval.
    [[nodiscard]] bool occludes(const Ray& ray, Interval interval) const;

    /// The bounding box of all triangles; empty if there are none.
    [[nodiscard]] BoundingBox bounds() const { return bounds_; }

private:
    [[nodiscard]] Ray scaled(const Ray& ray) const {
        return {.origin = scale_ * ray.origin, .direction = ray.direction};
    }

    [[nodiscard]] Interval scaled(Interval interval) const {
        return {.min = scale_ * interval.min, .max = scale_ * interval.max};
    }

    /// The hits on the triangles of a leaf.
    [[nodiscard]] Crossings crossings(const WatertightTest& test, const Ray& seen, std::size_t leaf,
                                      const Interval& interval) const {
        if (finer_.empty()) return test(packets_[leaf], interval);
        return finely(test, seen, leaf, interval);
    }

    /// As crossings, with each triangle that is too small for the test scaled separately.
    [[nodiscard]] Crossings finely(const WatertightTest& test, const Ray& seen, std::size_t leaf,
                                   const Interval& interval) const;

    BoundingBox bounds_;
    Real scale_ = 1;  ///< scale of packets and hierarchy: a power of two, so that it is exact
    Bvh hierarchy_;
    std::vector<Triangle4> packets_;  ///< one packet for each leaf
    /// For each leaf, the factors by which its triangles must be enlarged for the test: powers of
    /// two. Empty if all triangles are large enough.
    std::vector<std::array<Real, lane_count>> finer_;
};

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
