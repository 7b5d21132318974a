#include "common/bvh/mesh_bvh.hpp"

#include "common/geometry/bounds.hpp"
#include "common/system/huge_pages.hpp"

#include <algorithm>
#include <future>
#include <span>

namespace rt {
inline namespace RT_PRECISION {

inline namespace RT_LANES {

namespace {

/// The power of two that scales the largest coordinate to between 1 and 2, so that no area over- or
/// underflows; limited so that its inverse is finite.
Real scale_for(const BoundingBox& bounds) {
    const Real largest = largest_component(bounds);
    if (!(largest > 0 && largest < infinity)) return 1;
    constexpr int most = std::numeric_limits<Real>::max_exponent - 2;
    return std::ldexp(Real(1), std::clamp(-std::ilogb(largest), -most, most));
}

/// Returns whether float packets of the mesh have the same coordinates as those of a wider Real.
bool fits_in_floats(const Mesh& mesh, Real scale) {
    const auto is_float = [](Real value) { return Real(float(value)) == value; };
    return sizeof(Real) > sizeof(float) &&
           std::ranges::all_of(mesh.vertices, [&](const Vec3& vertex) {
               const Vec3 point = scale * vertex;
               return is_float(point.x) && is_float(point.y) && is_float(point.z);
           });
}

template <class Number>
TrianglePacket<Number> packed(const Mesh& mesh, const Leaf& leaf, Real scale) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    std::array<std::array<std::array<Number, real_count>, 3>, 3> lanes;
    for (std::size_t i = 0; i < real_count; ++i)
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            Vec3 point(nan);
            if (leaf.indices[i] != Leaf::none)
                point = scale * mesh.vertices[mesh.triangles[leaf.indices[i]][vertex]];
            lanes[vertex][0][i] = Number(point.x);
            lanes[vertex][1][i] = Number(point.y);
            lanes[vertex][2][i] = Number(point.z);
        }
    return std::bit_cast<TrianglePacket<Number>>(lanes);
}

/// Packs the triangles of each leaf, half of the leaves on a second thread if the system has one.
template <class Number>
auto packed(const Mesh& mesh, std::span<const Leaf> leaves, Real scale) {
    std::vector<TrianglePacket<Number>> packets;
    reserve_huge(packets, leaves.size());
    packets.resize(leaves.size());
    const auto fill = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            packets[i] = packed<Number>(mesh, leaves[i], scale);
    };
    const auto half = std::async([&] { fill(0, leaves.size() / 2); });
    fill(leaves.size() / 2, leaves.size());
    half.wait();
    return packets;
}

/// The factor by which a triangle of that size must be enlarged so that areas times lengths do not
/// underflow: needed in a mesh of size 1 below 2^-30 in float, 2^-200 in double.
Real finer(Real size) {
    constexpr int least = sizeof(Real) == 4 ? -30 : -200;
    if (!(size > 0 && size < std::ldexp(Real(1), least))) return 1;
    constexpr int most = std::numeric_limits<Real>::max_exponent * 3 / 4;
    return std::ldexp(Real(1), std::min(-std::ilogb(size), most));
}

Real size(const TrianglePacket<Real>& packet, std::size_t lane) {
    BoundingBox box;
    for (const auto& [x, y, z] : packet.vertices)
        box = merged(box, Vec3(values(x)[lane], values(y)[lane], values(z)[lane]));
    return largest_component(box.max - box.min);
}

std::vector<std::array<Real, real_count>> finer(const std::vector<TrianglePacket<Real>>& packets) {
    std::vector<std::array<Real, real_count>> scales(packets.size());
    bool any = false;
    for (std::size_t leaf = 0; leaf < packets.size(); ++leaf)
        for (std::size_t lane = 0; lane < real_count; ++lane) {
            scales[leaf][lane] = finer(size(packets[leaf], lane));
            any = any || scales[leaf][lane] != 1;
        }
    if (!any) return {};
    return scales;
}

/// The same visits, and the number of boxes of the nodes.
template <class Visit>
struct CountingBoxes : Visit {
    std::int64_t* count;

    void node() const { *count += std::int64_t(Node::width); }
};

TrianglePacket<Real> enlarged(TrianglePacket<Real> packet, Real scale) {
    for (auto& vertex : packet.vertices)
        for (RealN& coordinate : vertex) coordinate = all_of<Real, real_count>(scale) * coordinate;
    return packet;
}

}  // namespace

MeshBvh::MeshBvh(const Mesh& mesh) {
    bounds_ = rt::bounds(mesh);
    scale_ = scale_for(bounds_);
    const auto box = [&](std::size_t triangle) {
        const auto& [i, j, k] = mesh.triangles[triangle];
        const Vec3& a = mesh.vertices[i];
        const Vec3& b = mesh.vertices[j];
        const Vec3& c = mesh.vertices[k];
        return BoundingBox{.min = scale_ * glm::min(a, glm::min(b, c)),
                           .max = scale_ * glm::max(a, glm::max(b, c))};
    };
    hierarchy_ = Bvh(mesh.triangles.size(), box, Bvh::Leaves::packed);
    if (fits_in_floats(mesh, scale_)) {
        // None is too small for the test: the smallest float is 2^-149.
        float_packets_ = packed<float>(mesh, hierarchy_.leaves(), scale_);
    } else {
        packets_ = packed<Real>(mesh, hierarchy_.leaves(), scale_);
        finer_ = finer(packets_);
    }
}

Crossings MeshBvh::finely(Ray seen, std::size_t leaf, Interval interval) const {
    // If triangle and ray are scaled by a power of two, t does not change and areas keep their
    // signs: neighbors with different scales leave no crack.
    Crossings all = WatertightTest(seen)(packets_[leaf], interval);
    auto t = values(all.t);
    std::array areas = {values(all.areas[0]), values(all.areas[1]), values(all.areas[2])};
    for (std::size_t lane = 0; lane < real_count; ++lane) {
        const Real scale = finer_[leaf][lane];
        if (scale == 1) continue;
        const WatertightTest near(
            {.origin = scale * seen.origin, .direction = scale * seen.direction});
        const Crossings found = near(enlarged(packets_[leaf], scale), interval);
        const unsigned bit = 1U << lane;
        all.hits = (all.hits & ~bit) | (found.hits & bit);
        t[lane] = values(found.t)[lane];
        for (std::size_t i = 0; i < 3; ++i) areas[i][lane] = values(found.areas[i])[lane];
    }
    all.t = std::bit_cast<RealN>(t);
    for (std::size_t i = 0; i < 3; ++i) all.areas[i] = std::bit_cast<RealN>(areas[i]);
    return all;
}

std::int64_t MeshBvh::test_count(const Ray& ray, Interval interval, QueryKind query) const {
    const Ray seen = scaled(ray);
    const WatertightTest test(seen);
    Interval left = scaled(interval);
    std::int64_t count = 0;
    const auto visit = [&](std::size_t leaf) {
        count += std::int64_t(real_count);
        const Crossings found = crossings(test, seen, leaf, left);
        for (unsigned hits = found.hits; hits != 0;)
            left.max = std::min(left.max, lane(found.t, pop_lowest_bit(hits)));
        return query == QueryKind::any_hit && found.hits != 0;
    };
    const auto slabs = hierarchy_.test_of(seen, RaySlopes(seen.direction));
    const CountingBoxes<decltype(visit)> counting{visit, &count};
    if (query == QueryKind::any_hit)
        hierarchy_.visit_leaves<QueryKind::any_hit>(slabs, left, counting);
    else
        hierarchy_.visit_leaves<QueryKind::closest_hit>(slabs, left, counting);
    return count;
}

#ifndef RT_EXACT  // RT_EXACT uses steps/step13_meshes/exact/mesh_bvh.cpp
// Flattened: the tests of a leaf and of a node keep the ray in registers.
[[gnu::flatten]] std::optional<MeshHit> MeshBvh::nearest(const Ray& ray, Interval interval) const {
    const Ray seen = scaled(ray);
    const RaySlopes slopes(seen.direction);
    const WatertightTest test(seen, slopes);
    Interval left = scaled(interval);
    std::uint32_t triangle = 0;  // none is lower: no hit at the interval's own end counts
    Vec3 areas;
    hierarchy_.visit_leaves<QueryKind::closest_hit>(
        hierarchy_.test_of(seen, slopes), left,
        [&](std::size_t leaf) {
            const Crossings found = crossings(test, seen, leaf, left);
            for (unsigned hits = found.hits; hits != 0;) {
                const std::size_t i = pop_lowest_bit(hits);
                const Real t = lane(found.t, i);
                const std::uint32_t index = hierarchy_.leaves()[leaf].indices[i];
                if (t > left.max || (t == left.max && index >= triangle)) continue;
                left.max = t;
                triangle = index;
                areas = {lane(found.areas[0], i), lane(found.areas[1], i), lane(found.areas[2], i)};
            }
            return false;
        },
        [this](std::size_t leaf) { expect(leaf); });
    if (!(left.max < scaled(interval).max)) return std::nullopt;
    return MeshHit{.t = left.max / scale_,
                   .triangle = triangle,
                   .weights = areas / (areas.x + areas.y + areas.z)};
}

[[gnu::flatten]] bool MeshBvh::occludes(const Ray& ray, Interval interval) const {
    const Ray seen = scaled(ray);
    const RaySlopes slopes(seen.direction);
    const WatertightTest test(seen, slopes);
    const Interval left = scaled(interval);
    return hierarchy_.visit_leaves<QueryKind::any_hit>(
        hierarchy_.test_of(seen, slopes), left,
        [&](std::size_t leaf) {
            const Crossings found = crossings(test, seen, leaf, left);
            for (unsigned hits = found.hits; hits != 0;)
                if (lane(found.t, pop_lowest_bit(hits)) < left.max) return true;
            return false;
        },
        [this](std::size_t leaf) { expect(leaf); });
}
#endif

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
