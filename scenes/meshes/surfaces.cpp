#include "scenes/meshes/surfaces.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

namespace rt {

namespace {

Polygons icosahedron() {
    const double g = std::numbers::phi;
    return {.vertices = {{-1, g, 0},
                         {1, g, 0},
                         {-1, -g, 0},
                         {1, -g, 0},
                         {0, -1, g},
                         {0, 1, g},
                         {0, -1, -g},
                         {0, 1, -g},
                         {g, 0, -1},
                         {g, 0, 1},
                         {-g, 0, -1},
                         {-g, 0, 1}},
            .faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
}

/// An icosahedron's faces, each cut into n² triangles. Neighbors share the vertices between them.
class CutIcosahedron {
public:
    explicit CutIcosahedron(int n) : n_(n), ends_(icosahedron()) {
        result_.vertices = ends_.vertices;
        for (const std::vector<int>& face : ends_.faces) cut(face);
    }
    [[nodiscard]] const Polygons& result() const { return result_; }

private:
    void cut(const std::vector<int>& face) {
        // Row i has n − i + 1 vertices, from one edge of the face to another.
        std::vector<std::vector<int>> rows;
        for (int i = 0; i <= n_; ++i) {
            rows.emplace_back();
            for (int j = 0; j <= n_ - i; ++j) rows.back().push_back(vertex(face, n_ - i - j, i, j));
        }
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            const std::vector<int>& row = rows[i];
            const std::vector<int>& next = rows[i + 1];
            for (std::size_t j = 0; j < next.size(); ++j) {
                result_.faces.push_back({row[j], next[j], row[j + 1]});
                if (j > 0) result_.faces.push_back({next[j - 1], next[j], row[j]});
            }
        }
    }

    /// The vertex that is a, b and c parts of n of the face's corners.
    int vertex(const std::vector<int>& face, int a, int b, int c) {
        if (a == n_) return face[0];
        if (b == n_) return face[1];
        if (c == n_) return face[2];
        if (c == 0) return on_edge(face[0], face[1], b);
        if (b == 0) return on_edge(face[0], face[2], c);
        if (a == 0) return on_edge(face[1], face[2], c);
        return add(double(a) * corner(face[0]) + double(b) * corner(face[1]) +
                   double(c) * corner(face[2]));
    }

    int on_edge(int from, int to, int part) {
        if (from > to) return on_edge(to, from, n_ - part);
        const auto [place, is_new] = edges_.try_emplace({from, to, part}, 0);
        if (is_new) {
            place->second = add(double(n_ - part) * corner(from) + double(part) * corner(to));
        }
        return place->second;
    }

    [[nodiscard]] glm::dvec3 corner(int i) const {
        return ends_.vertices[static_cast<std::size_t>(i)];
    }
    int add(glm::dvec3 point) {
        result_.vertices.push_back(point);
        return static_cast<int>(result_.vertices.size()) - 1;
    }

    int n_;
    Polygons ends_;
    Polygons result_;
    std::map<std::array<int, 3>, int> edges_;
};

/// Of four sizes, each half as high as the one before; sines, as they are smooth and repeatable.
double height(glm::dvec3 direction) {
    double result = 1;
    double frequency = 4;
    double amplitude = 0.1;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 wave = frequency * direction + glm::dvec3(0.3, 1.7, 2.9) * double(i + 1);
        result += amplitude * std::sin(wave.x) * std::sin(wave.y) * std::sin(wave.z);
        frequency *= 2.1;
        amplitude /= 2;
    }
    return result;
}

}  // namespace

Polygons cube() {
    return cut_up(box(glm::dvec3(0), glm::dvec3(1)));
}

Polygons cut_icosahedron(int n) {
    return CutIcosahedron(n).result();
}

Polygons hilly_sphere(int n) {
    Polygons sphere = cut_icosahedron(n);
    for (glm::dvec3& v : sphere.vertices) {
        const glm::dvec3 direction = glm::normalize(v);
        v = height(direction) * direction;
    }
    return sphere;
}

Polygons pebble_cage() {
    Polygons cage = icosahedron();
    for (glm::dvec3& v : cage.vertices) {
        v = glm::normalize(v);
        v *= 1.2 + 0.2 * std::sin(3 * v.x + 5 * v.y + 7 * v.z);
        v *= glm::dvec3(1.2, 0.55, 0.9);
    }
    return cage;
}

Polygons bowl(int corners) {
    // Radius and height, from the middle of the foot up to the rim.
    constexpr std::array<std::array<double, 2>, 7> outline = {{{0.30, 0},
                                                               {0.42, 0.02},
                                                               {0.70, 0.14},
                                                               {0.90, 0.36},
                                                               {0.98, 0.60},
                                                               {1.00, 0.80},
                                                               {1.04, 0.90}}};
    Polygons result = {.vertices = {glm::dvec3(0)}};
    for (const auto& [radius, y] : outline) {
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            result.vertices.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
        }
    }
    for (int k = 0; k < corners; ++k) {
        const int next = (k + 1) % corners;
        result.faces.push_back({0, 1 + k, 1 + next});
        for (int row = 1; row + corners < static_cast<int>(result.vertices.size());
             row += corners) {
            result.faces.push_back({row + k, row + corners + k, row + corners + next});
            result.faces.push_back({row + k, row + corners + next, row + next});
        }
    }
    return result;
}

Polygons book() {
    constexpr int pages = 7;
    Polygons result = {.vertices = {{0, 0, 0.7}, {0, 0, -0.7}}};
    for (int page = 0; page < pages; ++page) {
        const double angle = std::numbers::pi * (page + 0.5) / pages;
        const glm::dvec3 edge(std::cos(angle), std::sin(angle), 0);
        const int front = static_cast<int>(result.vertices.size());
        result.vertices.push_back(edge + glm::dvec3(0, 0, 0.7));
        result.vertices.push_back(edge - glm::dvec3(0, 0, 0.7));
        result.faces.push_back({0, front, front + 1, 1});
    }
    return result;
}

}  // namespace rt
