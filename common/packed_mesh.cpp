#include "common/packed_mesh.hpp"

#include "common/bounds.hpp"

#include <cmath>

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

namespace {

/// Where a ray crosses the planes of four triangles.
struct Crossings {
    std::array<Lanes, 3> areas;  ///< opposite to each vertex, as the ray sees the triangle
    Lanes t;
    unsigned hits;  ///< one bit a triangle
};

/// Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", for four triangles.
///
/// The frame is changed so that the ray is the z axis; a vertex gets the same bits there in
/// whichever triangle it stands. An area's sign is then never wrong, for rounding keeps the order
/// of the two products it is the difference of: at worst it is 0, which counts as inside. So a ray
/// through a shared edge or vertex meets at least one of the triangles. No fma is needed for that,
/// and without -march it would be a call.
class TriangleTest {
public:
    explicit TriangleTest(const Ray& ray) {
        const Vec3 size = abs(ray.direction);
        z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        const Vec3& d = ray.direction;
        const auto x = glm::length_t(x_);
        const auto y = glm::length_t(y_);
        const auto z = glm::length_t(z_);
        origin_ = {all_lanes(ray.origin[x]), all_lanes(ray.origin[y]), all_lanes(ray.origin[z])};
        shear_x_ = all_lanes(d[x] / d[z]);
        shear_y_ = all_lanes(d[y] / d[z]);
        inverse_z_ = all_lanes(1 / d[z]);
    }

    [[nodiscard]] Crossings operator()(const TrianglePacket& packet, Interval interval) const {
        const auto [ax, ay, az] = sheared(packet.vertices[0]);
        const auto [bx, by, bz] = sheared(packet.vertices[1]);
        const auto [cx, cy, cz] = sheared(packet.vertices[2]);
        const Lanes alpha = bx * cy - by * cx;
        const Lanes beta = cx * ay - cy * ax;
        const Lanes gamma = ax * by - ay * bx;
        // Smallest and largest of the three; NaN must miss, and does so by its t.
        const Lanes zero = all_lanes(0);
        const Mask inside =
            (zero <= min(min(alpha, beta), gamma)) | (max(max(alpha, beta), gamma) <= zero);
        const Lanes t = (alpha * az + beta * bz + gamma * cz) / (alpha + beta + gamma) * inverse_z_;
        const Mask hits = inside & (all_lanes(interval.min) < t) & (t < all_lanes(interval.max));
        return {.areas = {alpha, beta, gamma}, .t = t, .hits = bits(hits)};
    }

private:
    [[nodiscard]] std::array<Lanes, 3> sheared(const std::array<Lanes, 3>& vertex) const {
        const Lanes z = vertex[z_] - origin_[2];
        return {vertex[x_] - origin_[0] - shear_x_ * z, vertex[y_] - origin_[1] - shear_y_ * z, z};
    }

    std::size_t x_;
    std::size_t y_;
    std::size_t z_;  ///< the axis along which the direction is longest
    std::array<Lanes, 3> origin_;
    Lanes shear_x_;
    Lanes shear_y_;
    Lanes inverse_z_;
};

TrianglePacket packed(const Mesh& mesh, const Leaf& leaf, Real scale) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    std::array<std::array<std::array<Real, lane_count>, 3>, 3> lanes;
    for (std::size_t i = 0; i < lane_count; ++i)
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            Vec3 point(nan);
            if (leaf.indices[i] != Leaf::none)
                point = scale * mesh.vertices[mesh.triangles[leaf.indices[i]][vertex]];
            for (glm::length_t axis = 0; axis < 3; ++axis)
                lanes[vertex][std::size_t(axis)][i] = point[axis];
        }
    TrianglePacket packet;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t axis = 0; axis < 3; ++axis)
            packet.vertices[vertex][axis] = lanes_of(lanes[vertex][axis]);
    return packet;
}

/// The power of two that brings the largest coordinate between 1 and 2, as far as it can be one
/// whose inverse is finite too.
Real scale_for(const Box& bounds) {
    const Vec3 size = glm::max(abs(bounds.min), abs(bounds.max));
    const Real largest = glm::max(size.x, glm::max(size.y, size.z));
    if (!(largest > 0) || largest == infinity) return 1;
    constexpr int most = std::numeric_limits<Real>::max_exponent - 2;
    return std::ldexp(Real(1), std::clamp(-std::ilogb(largest), -most, most));
}

}  // namespace

PackedMesh::PackedMesh(const Mesh& mesh) : bounds_(rt::bounds(mesh)), scale_(scale_for(bounds_)) {
    std::vector<Box> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        Box box;
        for (const std::uint32_t vertex : triangle)
            box = united(box, scale_ * mesh.vertices[vertex]);
        boxes.push_back(box);
    }
    hierarchy_ = Hierarchy(boxes, Hierarchy::Leaves::packed);
    packets_.reserve(hierarchy_.leaves().size());
    for (const Leaf& leaf : hierarchy_.leaves()) packets_.push_back(packed(mesh, leaf, scale_));
}

Ray PackedMesh::scaled(const Ray& ray) const {
    return {.origin = scale_ * ray.origin, .direction = ray.direction};
}

Interval PackedMesh::scaled(Interval interval) const {
    return {.min = scale_ * interval.min, .max = scale_ * interval.max};
}

std::optional<MeshHit> PackedMesh::nearest(const Ray& ray, Interval interval) const {
    const Ray scaled_ray = scaled(ray);
    Interval left = scaled(interval);
    const TriangleTest test(scaled_ray);
    MeshHit best;
    std::size_t leaf_hit = 0, lane_hit = lane_count;
    hierarchy_.visit_leaves(scaled_ray, left, [&](std::size_t leaf) {
        const Crossings crossings = test(packets_[leaf], left);
        if (crossings.hits == 0) return false;
        const auto t = values(crossings.t);
        for (unsigned hits = crossings.hits; hits != 0;) {
            const std::size_t lane = take_lowest(hits);
            if (!(t[lane] < left.max)) continue;
            left.max = t[lane];
            leaf_hit = leaf;
            lane_hit = lane;
            best.weights = {values(crossings.areas[0])[lane], values(crossings.areas[1])[lane],
                            values(crossings.areas[2])[lane]};
        }
        return false;
    });
    if (lane_hit == lane_count) return std::nullopt;
    best.t = left.max / scale_;
    best.triangle = hierarchy_.leaves()[leaf_hit].indices[lane_hit];
    best.weights /= best.weights.x + best.weights.y + best.weights.z;
    return best;
}

bool PackedMesh::blocks(const Ray& ray, Interval interval) const {
    const Ray scaled_ray = scaled(ray);
    const Interval left = scaled(interval);
    const TriangleTest test(scaled_ray);
    return hierarchy_.visit_leaves(
        scaled_ray, left, [&](std::size_t leaf) { return test(packets_[leaf], left).hits != 0; });
}

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
