// Polygons cut into triangles: the same area, n − 2 triangles, none outside.

#include "common/mesh_file/triangulate.hpp"

#include "tests/kit/catch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace rt;

namespace {

using Corners = std::vector<glm::dvec3>;

glm::dvec3 area_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a) / 2.0;
}

/// The areas of the triangles along z, all of which must be positive.
double sum_of_positive(const Corners& corners) {
    double sum = 0;
    for (const auto& [a, b, c] : triangulate(corners)) {
        const double area = area_of(corners[a], corners[b], corners[c]).z;
        CHECK(area > 0);
        sum += area;
    }
    return sum;
}

/// A star of n points, with every second corner nearer to the middle.
Corners star(int points, double inner) {
    Corners corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points;
        const double radius = i % 2 == 0 ? 1 : inner;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    return corners;
}

}  // namespace

TEST_CASE("fewer than three corners have no triangle") {
    CHECK(triangulate(Corners{}).empty());
    CHECK(triangulate(Corners{{0, 0, 0}}).empty());
    CHECK(triangulate(Corners{{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("a convex polygon is a fan around its first corner") {
    const Corners square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    using Fan = std::vector<std::array<std::uint32_t, 3>>;
    CHECK(triangulate(std::span(square).first(3)) == Fan{{0, 1, 2}});
    CHECK(triangulate(square) == Fan{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a dart, whichever corner comes first: the diagonal is the one inside") {
    Corners dart = {{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
    for (int first = 0; first < 4; ++first) {
        CHECK(triangulate(dart).size() == 2);
        CHECK(sum_of_positive(dart) == 0.5);  // two of base 1/2 and height 1
        std::rotate(dart.begin(), dart.begin() + 1, dart.end());
    }
}

TEST_CASE("a comb and stars keep their area") {
    const Corners comb = {{0, 0, 0}, {7, 0, 0}, {7, 3, 0}, {6, 1, 0}, {5, 3, 0},
                          {4, 1, 0}, {3, 3, 0}, {2, 1, 0}, {1, 3, 0}, {0, 1, 0}};
    CHECK(triangulate(comb).size() == 8);
    // A strip 7 wide and 1 high, two teeth of base 2 and height 2, half a tooth more at the right,
    // of base 1, and at the left one from 0 to 2.
    CHECK(sum_of_positive(comb) == 7 + 2 + 2 + 1 + 2);
    for (const int points : {3, 5, 50, 500}) {
        const Corners corners = star(points, 0.3);
        CHECK(triangulate(corners).size() == corners.size() - 2);
        const double expected = points * 0.3 * std::sin(std::numbers::pi / points);
        CHECK(std::abs(sum_of_positive(corners) - expected) <= 1e-12);
    }
}

TEST_CASE("it turns as the polygon does, in any plane") {
    const Corners flat = star(5, 0.3);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            Corners rotated;
            glm::dvec3 normal(0);
            normal[axis] = side;
            for (const glm::dvec3& p : flat) {
                glm::dvec3 q(0);
                q[(axis + 1) % 3] = p.x;
                q[(axis + 2) % 3] = side * p.y;
                q[axis] = 0.1 * p.x + 0.2 * p.y;  // not along an axis
                rotated.push_back(q);
            }
            const auto triangles = triangulate(rotated);
            CHECK(triangles.size() == 8);
            for (const auto& [a, b, c] : triangles) {
                CHECK(glm::dot(area_of(rotated[a], rotated[b], rotated[c]), normal) > 0);
            }
        }
    }
}

TEST_CASE("a corner in the middle of an edge is a corner of some triangle") {
    const Corners corners = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    CHECK(triangulate(corners).size() == 4);
    CHECK(sum_of_positive(corners) == 4);
}

TEST_CASE("a hole on a bridge is left out") {
    const Corners corners = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                             {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
    CHECK(triangulate(corners).size() == 8);
    CHECK(sum_of_positive(corners) == 8);
}

TEST_CASE("a polygon without area, with crossings or repeated corners gives n - 2 triangles") {
    const std::vector<Corners> all = {
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                        // a line
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},             // a point
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                        // a bow tie
        {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}},                        // an uneven one
        {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 0, 0}},  // each twice
        {{0, 0, 0}, {1, 0, 5}, {1, 1, 0}, {0, 1, 5}, {-1, 0, 9}},            // far from flat
        {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 1, 0}},             // back on itself
        {{0, 0, 0}, {3e38, 0, 0}, {3e38, 3e38, 0}, {1e38, 2e38, 0}, {0, 3e38, 0}},
        {{0, 0, 0}, {1e-45, 0, 0}, {1e-45, 1e-45, 0}, {0, 1e-45, 0}},
    };
    for (const Corners& corners : all) {
        const auto triangles = triangulate(corners);
        CHECK(triangles.size() == corners.size() - 2);
        for (const auto& [a, b, c] : triangles) {
            CHECK(std::max({a, b, c}) < corners.size());
            CHECK((a != b && b != c && c != a));
        }
    }
}
