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

using Corners = std::array<Vec3, 3>;

Corners corners(const Mesh& mesh, std::uint32_t triangle, Real scale) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {scale * mesh.vertices[a], scale * mesh.vertices[b], scale * mesh.vertices[c]};
}

/// Returns whether the rounded areas of a triangle, in a mesh of size 1 to 2, are too inaccurate.
/// Their errors are up to 2 u times the square of its longest side, and move a hit across the plane
/// by up to 6 u times that square times the side divided by twice the triangle's area: by more than
/// 6 u, if this ratio exceeds 1, and a ray that leaves the triangle may hit it again
/// (projection_error). Below 2^-30 in float, 2^-200 in double, areas times lengths underflow.
bool needs_care(const Corners& corners) {
    using Wide = glm::dvec3;  // squares of areas stay in the range of double
    const Wide ab(corners[1] - corners[0]);
    const Wide ac(corners[2] - corners[0]);
    const Wide bc(corners[2] - corners[1]);
    const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
    const Wide area = cross(ab, ac);
    constexpr double least = sizeof(Real) == 4 ? 0x1p-60 : 0x1p-400;
    return longest < least || longest * longest * longest > dot(area, area);
}

/// Packs the triangles of a leaf. Returns one bit for each that needs care.
template <class Number>
std::uint8_t pack(const Mesh& mesh, const Leaf& leaf, Real scale, TrianglePacket<Number>& packet) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    std::array<std::array<std::array<Number, real_count>, 3>, 3> lanes;
    unsigned careful = 0;
    for (std::size_t i = 0; i < real_count; ++i) {
        Corners points = {Vec3(nan), Vec3(nan), Vec3(nan)};
        if (leaf.indices[i] != Leaf::none) points = corners(mesh, leaf.indices[i], scale);
        if (needs_care(points)) careful |= 1U << i;
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            lanes[vertex][0][i] = Number(points[vertex].x);
            lanes[vertex][1][i] = Number(points[vertex].y);
            lanes[vertex][2][i] = Number(points[vertex].z);
        }
    }
    packet = std::bit_cast<TrianglePacket<Number>>(lanes);
    return std::uint8_t(careful);
}

/// Packs the triangles of each leaf, half of the leaves on a second thread if the system has one,
/// and returns which of their triangles need care: nothing if none does.
template <class Number>
std::vector<std::uint8_t> pack(const Mesh& mesh, std::span<const Leaf> leaves, Real scale,
                               std::vector<TrianglePacket<Number>>& packets) {
    reserve_huge(packets, leaves.size());
    packets.resize(leaves.size());
    std::vector<std::uint8_t> careful(leaves.size());
    const auto fill = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            careful[i] = pack(mesh, leaves[i], scale, packets[i]);
    };
    const auto half = std::async([&] { fill(0, leaves.size() / 2); });
    fill(leaves.size() / 2, leaves.size());
    half.wait();
    if (std::ranges::count(careful, 0) == std::ssize(careful)) return {};
    return careful;
}

/// The same test, and the number of boxes tested.
struct CountingTest : RayBoxTest<true> {
    std::int64_t* count;

    [[nodiscard]] Answer operator()(const Node& node, float limit) const {
        *count += std::int64_t(Node::width);
        return RayBoxTest::operator()(node, limit);
    }
};

}  // namespace

MeshBvh::MeshBvh(const Mesh& mesh) {
    bounds_ = rt::bounds(mesh);
    scale_ = scale_for(bounds_);
    const auto box = [&](std::size_t triangle) {
        const auto [a, b, c] = corners(mesh, std::uint32_t(triangle), scale_);
        return BoundingBox{.min = glm::min(a, glm::min(b, c)), .max = glm::max(a, glm::max(b, c))};
    };
    hierarchy_ = Bvh(mesh.triangles.size(), box, Bvh::Leaves::packed);
    careful_ = fits_in_floats(mesh, scale_)
                   ? pack(mesh, hierarchy_.leaves(), scale_, float_packets_)
                   : pack(mesh, hierarchy_.leaves(), scale_, packets_);
}

std::int64_t MeshBvh::test_count(const Ray& ray, Interval interval, QueryKind query) const {
    const Ray seen = scaled(ray);
    const WatertightTest test(seen);
    Interval left = scaled(interval);
    std::int64_t count = 0;
    const auto visit = [&](std::size_t leaf) {
        count += std::int64_t(real_count);
        return with_crossings(ray, test, leaf, left, [&](const Crossings& found) {
            for (unsigned hits = found.hits; hits != 0;)
                left.max = std::min(left.max, lane(found.t, pop_lowest_bit(hits)));
            return query == QueryKind::any_hit && found.hits != 0;
        });
    };
    const CountingTest slabs{hierarchy_.test_of(seen, RaySlopes(seen.direction)), &count};
    if (query == QueryKind::any_hit)
        hierarchy_.visit_leaves<QueryKind::any_hit>(slabs, left, visit);
    else
        hierarchy_.visit_leaves<QueryKind::closest_hit>(slabs, left, visit);
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
            return with_crossings(ray, test, leaf, left, [&](const Crossings& found) {
                for (unsigned hits = found.hits; hits != 0;) {
                    const std::size_t i = pop_lowest_bit(hits);
                    const Real t = lane(found.t, i);
                    const std::uint32_t index = hierarchy_.leaves()[leaf].indices[i];
                    if (t > left.max || (t == left.max && index >= triangle)) continue;
                    left.max = t;
                    triangle = index;
                    areas = {lane(found.areas[0], i), lane(found.areas[1], i),
                             lane(found.areas[2], i)};
                }
                return false;
            });
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
            return with_crossings(ray, test, leaf, left, [&](const Crossings& found) {
                for (unsigned hits = found.hits; hits != 0;)
                    if (lane(found.t, pop_lowest_bit(hits)) < left.max) return true;
                return false;
            });
        },
        [this](std::size_t leaf) { expect(leaf); });
}
#endif

}  // namespace RT_LANES
}  // namespace RT_PRECISION
}  // namespace rt
