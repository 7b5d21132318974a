// A mesh made ready for rays: four triangles at a time, under a hierarchy, and watertight.
#pragma once

#include "common/hierarchy.hpp"
#include "common/mesh.hpp"
#include "common/triangle_packet.hpp"

#include <optional>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// The triangles of a mesh. The mesh itself is not needed any more once they are packed.
class PackedMesh {
public:
    PackedMesh() = default;
    explicit PackedMesh(const Mesh& mesh);

    /// Where the ray first meets the mesh strictly inside the interval, or nothing. No ray passes
    /// between triangles that share an edge or a vertex, however small they are beside the mesh.
    [[nodiscard]] std::optional<MeshHit> nearest(const Ray& ray, Interval interval) const;

    /// Whether the ray meets the mesh at all strictly inside the interval.
    [[nodiscard]] bool blocks(const Ray& ray, Interval interval) const;

    /// Around all triangles; empty if there are none.
    [[nodiscard]] Box bounds() const { return bounds_; }

private:
    [[nodiscard]] Ray scaled(const Ray& ray) const {
        return {.origin = scale_ * ray.origin, .direction = ray.direction};
    }

    [[nodiscard]] Interval scaled(Interval interval) const {
        return {.min = scale_ * interval.min, .max = scale_ * interval.max};
    }

    /// What the test finds in a leaf.
    [[nodiscard]] Crossings crossings(const TriangleTest& test, const Ray& seen, std::size_t leaf,
                                      const Interval& interval) const {
        if (finer_.empty()) return test(packets_[leaf], interval);
        return finely(test, seen, leaf, interval);
    }

    /// As crossings, with each triangle that is too small for the test in a scale of its own.
    [[nodiscard]] Crossings finely(const TriangleTest& test, const Ray& seen, std::size_t leaf,
                                   const Interval& interval) const;

    Box bounds_;
    Real scale_ = 1;  ///< of packets and hierarchy: a power of two, so that it rounds nothing
    Hierarchy hierarchy_;
    std::vector<TrianglePacket> packets_;  ///< one a leaf
    /// One a leaf: how much larger its triangles must be for the test, powers of two. None, if all
    /// are large enough.
    std::vector<std::array<Real, lane_count>> finer_;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
