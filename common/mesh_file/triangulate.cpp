#include "common/mesh_file/triangulate.hpp"

#include <glm/vec2.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rt {

namespace {

using Index = std::uint32_t;

/// Newell's sum: the normal of the polygon with twice its area as length, also for a polygon that
/// is not quite planar or has collinear corners (Sutherland, Sproull, Schumacker 1974).
glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - corners[0];
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - corners[0];
        sum += glm::cross(a, b);
    }
    return sum;
}

/// The corners projected along the axis of the largest projected area, and mirrored if needed:
/// counterclockwise around `area` becomes counterclockwise in the plane.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners, glm::dvec3 area) {
    const glm::dvec3 size = glm::abs(area);
    int axis = size.x > size.y ? 0 : 1;
    if (size.z > size[axis]) axis = 2;
    int right = (axis + 1) % 3;
    int up = (axis + 2) % 3;
    if (area[axis] < 0) std::swap(right, up);
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::dvec3& corner : corners) points.emplace_back(corner[right], corner[up]);
    return points;
}

/// Twice the signed area of the triangle, positive if it is counterclockwise.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Ear clipping: removes corners whose triangle is inside the polygon (Meisters 1975). The
/// remaining corners form a ring. Each corner is marked as reflex or not, and only reflex ones can
/// be inside an ear.
class Ears {
public:
    explicit Ears(std::vector<glm::dvec2> points) : points_(std::move(points)) {
        const auto count = static_cast<Index>(points_.size());
        for (Index i = 0; i < count; ++i) {
            next_.push_back(i + 1 < count ? i + 1 : 0);
            previous_.push_back(i > 0 ? i - 1 : count - 1);
        }
        for (Index i = 0; i < count; ++i) {
            is_reflex_.push_back(turn_at(i) <= 0);
            if (is_reflex_.back()) reflex_.push_back(i);
        }
    }

    /// Returns whether every corner turns left; because the area is positive, the polygon then has
    /// a winding number of one.
    [[nodiscard]] bool is_convex() const { return reflex_.empty(); }

    [[nodiscard]] std::vector<std::array<Index, 3>> cut() {
        std::vector<std::array<Index, 3>> triangles;
        for (Index i = 0; i < next_.size(); ++i) candidates_.push_back(i);
        std::vector<bool> gone(next_.size());
        Index somewhere = 0;
        while (triangles.size() + 2 < next_.size()) {
            // Without an ear, the polygon was not simple, or is degenerate: any corner is removed.
            Index ear = somewhere;
            while (!candidates_.empty()) {
                const Index i = candidates_.back();
                candidates_.pop_back();
                if (gone[i] || !is_ear(i)) continue;
                ear = i;
                break;
            }
            triangles.push_back({previous_[ear], ear, next_[ear]});
            gone[ear] = true;
            somewhere = next_[ear];
            remove(ear);
        }
        return triangles;
    }

private:
    [[nodiscard]] double turn_at(Index i) const {
        return turn(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    [[nodiscard]] bool is_ear(Index i) const {
        if (is_reflex_[i]) return false;
        const glm::dvec2 a = points_[previous_[i]];
        const glm::dvec2 b = points_[i];
        const glm::dvec2 c = points_[next_[i]];
        const glm::dvec2 low = glm::min(a, glm::min(b, c));
        const glm::dvec2 high = glm::max(a, glm::max(b, c));
        return std::ranges::none_of(reflex_, [&](Index r) {
            const glm::dvec2 p = points_[r];
            if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
            // A corner at the same position belongs to a bridge to a hole, or touches the triangle:
            // it does not block the ear.
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    void remove(Index ear) {
        const Index before = previous_[ear];
        const Index after = next_[ear];
        next_[before] = after;
        previous_[after] = before;
        if (is_reflex_[ear]) std::erase(reflex_, ear);
        // Only these two corners can have become ears (Eberly, "Triangulation by ear clipping",
        // 2002).
        for (const Index i : {before, after}) {
            if (is_reflex_[i] && turn_at(i) > 0) {
                is_reflex_[i] = false;
                std::erase(reflex_, i);
            }
            candidates_.push_back(i);
        }
    }

    std::vector<glm::dvec2> points_;
    std::vector<Index> next_;
    std::vector<Index> previous_;
    std::vector<bool> is_reflex_;
    std::vector<Index> reflex_;
    std::vector<Index> candidates_;
};

std::vector<std::array<Index, 3>> fan(Index count) {
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 2; i < count; ++i) triangles.push_back({0, i - 1, i});
    return triangles;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec3> corners) {
    const auto count = static_cast<Index>(corners.size());
    const glm::dvec3 area = count > 3 ? area_vector(corners) : glm::dvec3(0);
    if (area == glm::dvec3(0))
        return fan(count);  // a triangle, or a polygon without a plane of projection
    Ears ears(flattened(corners, area));
    return ears.is_convex() ? fan(count) : ears.cut();
}

}  // namespace rt
