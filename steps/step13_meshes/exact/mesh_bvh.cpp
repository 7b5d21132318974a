// The intersection of a packed mesh for `--precision exact`: stage 5's certified kernel, applied to
// one triangle after the other.
#include "common/bvh/mesh_bvh.hpp"
#include "common/exact/leader.hpp"
#include "common/math/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

namespace {

/// A triangle of a mesh. Of two hits at the same t, the triangle that is first in the mesh is
/// reported.
struct HitTriangle {
    std::uint32_t index = 0;
    Triangle triangle;

    friend bool operator<(const HitTriangle& a, const HitTriangle& b) { return a.index < b.index; }
};

/// Calls visit(HitTriangle, t) for the triangles of a leaf that the ray hits in the interval, until
/// a call returns true. Returns whether one did.
template <class Visit>
bool visit_hits(const Ray& ray, const Interval& interval, const Leaf& leaf,
                const TrianglePacket<Real>& packet, Visit visit) {
    for (std::size_t lane = 0; lane < real_count && leaf.indices[lane] != Leaf::none; ++lane) {
        const auto corner = [&](std::size_t vertex) {
            const auto& [x, y, z] = packet.vertices[vertex];
            return Vec3(values(x)[lane], values(y)[lane], values(z)[lane]);
        };
        const Triangle triangle{.a = corner(0), .b = corner(1), .c = corner(2)};
        const auto t = intersect(ray, triangle, interval);
        if (t && visit(HitTriangle{.index = leaf.indices[lane], .triangle = triangle}, *t))
            return true;
    }
    return false;
}

}  // namespace

std::optional<MeshHit> MeshBvh::nearest(const Ray& ray, Interval interval) const {
    const Ray seen = scaled(ray);
    Interval left = scaled(interval);
    const auto root_of = [&seen, asked = left](const HitTriangle& hit) {
        return exact_root(seen, hit.triangle, asked);
    };
    ClosestSoFar<HitTriangle> leader;
    hierarchy_.visit_leaves<QueryKind::closest_hit>(
        hierarchy_.test_of(seen, RaySlopes(seen.direction)), left, [&](std::size_t leaf) {
            return visit_hits(seen, left, hierarchy_.leaves()[leaf], packet(leaf),
                              [&](const HitTriangle& hit, Real t) {
                                  leader.accepts(t, hit, root_of, left);
                                  return false;
                              });
        });
    if (!(leader.t() < infinity)) return std::nullopt;
    const auto& [index, triangle] = leader.object();
    return MeshHit{.t = leader.t() / scale_,
                   .triangle = index,
                   .weights = barycentric(triangle, at(seen, leader.t()))};
}

bool MeshBvh::occludes(const Ray& ray, Interval interval) const {
    const Ray seen = scaled(ray);
    const Interval left = scaled(interval);
    return hierarchy_.visit_leaves<QueryKind::any_hit>(
        hierarchy_.test_of(seen, RaySlopes(seen.direction)), left, [&](std::size_t leaf) {
            return visit_hits(seen, left, hierarchy_.leaves()[leaf], packet(leaf),
                              [](const HitTriangle& /*hit*/, Real /*t*/) { return true; });
        });
}

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
