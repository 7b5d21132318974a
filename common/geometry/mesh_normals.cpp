#include "common/geometry/mesh_normals.hpp"

#include "common/geometry/mesh_edges.hpp"
#include "common/system/huge_pages.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace rt {

namespace {

/// Double in either precision: squares of a float stay in the range of double.
using Wide = glm::dvec3;

/// A sum of unit normals that is shorter than this part of its weights is no normal: it lies nearly
/// along the faces. Two faces that meet in so short a sum form a blade of less than 6 degrees, and
/// the two sides of a sheet whose copy is triangulated otherwise do.
constexpr double least_sum = 0.05;

/// The unit normal of a triangle, and its angles; the normal is 0 without an area.
struct Facet {
    Wide normal{0};
    std::array<double, 3> angles{};
};

Facet facet(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const Wide a = mesh.vertices[corners[0]];
    const Wide ab = Wide(mesh.vertices[corners[1]]) - a;
    const Wide ac = Wide(mesh.vertices[corners[2]]) - a;
    const Wide normal = glm::cross(ab, ac);
    const double length = glm::length(normal);
    if (!(length > 0)) return {};
    // Twice the triangle's area is the length of the cross product of any two of its sides. An
    // acos of their dot product would lose half the digits of a small angle.
    const double at_a = std::atan2(length, glm::dot(ab, ac));
    const double at_b = std::atan2(length, glm::dot(ab, ab - ac));
    return {.normal = normal / length, .angles = {at_a, at_b, std::numbers::pi - at_a - at_b}};
}

/// The weighted normals at a vertex.
struct Sum {
    Wide normals{0};
    double weights = 0;

    void add(const Facet& facet, std::size_t corner) {
        normals += facet.angles[corner] * facet.normal;
        weights += facet.angles[corner];
    }
    [[nodiscard]] bool cancels() const { return glm::length(normals) <= least_sum * weights; }
    [[nodiscard]] Vec3 normal() const {
        const double length = glm::length(normals);
        return length > 0 ? Vec3(normals / length) : Vec3(0, 0, 1);
    }
};

std::uint32_t add_copy(Mesh& mesh, std::vector<Sum>& sums, std::uint32_t vertex) {
    mesh.vertices.push_back(mesh.vertices[vertex]);
    sums.emplace_back();
    return static_cast<std::uint32_t>(sums.size() - 1);
}

/// Divides the faces around each vertex whose sum cancels into those that look to the side of the
/// first, which keep the vertex, and the others, which get a copy.
void split_sides(Mesh& mesh, std::vector<Sum>& sums) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    struct Sides {
        Wide first{0};
        std::uint32_t copy = none;
    };
    std::vector<Sides> sides(sums.size());  // of a vertex that does not cancel, unused
    std::vector<bool> cancels(sums.size());
    for (std::size_t i = 0; i < cancels.size(); ++i) {
        cancels[i] = sums[i].weights > 0 && sums[i].cancels();
        if (cancels[i]) sums[i] = {};
    }
    for (auto& corners : mesh.triangles) {
        const Facet face = facet(mesh, corners);
        for (std::size_t i = 0; i < 3; ++i) {
            std::uint32_t& corner = corners[i];
            if (!cancels[corner] || face.normal == Wide(0)) continue;
            auto& [first, copy] = sides[corner];
            if (first == Wide(0)) first = face.normal;
            if (glm::dot(first, face.normal) < 0) {
                if (copy == none) copy = add_copy(mesh, sums, corner);
                corner = copy;
            }
            sums[corner].add(face, i);
        }
    }
}

void set_normals(Mesh& mesh, std::span<const Sum> sums) {
    mesh.normals.clear();
    reserve_huge(mesh.normals, sums.size());
    for (const Sum& sum : sums) mesh.normals.push_back(sum.normal());
}

}  // namespace

void add_smooth_normals(Mesh& mesh) {
    std::vector<Sum> sums;
    reserve_huge(sums, mesh.vertices.size());
    sums.resize(mesh.vertices.size());
    for (const auto& corners : mesh.triangles) {
        const Facet face = facet(mesh, corners);
        for (std::size_t i = 0; i < 3; ++i) sums[corners[i]].add(face, i);
    }
    const auto is_noise = [](const Sum& sum) { return sum.weights > 0 && sum.cancels(); };
    if (std::ranges::any_of(sums, is_noise)) split_sides(mesh, sums);
    set_normals(mesh, sums);
}

void add_creased_normals(Mesh& mesh, double angle) {
    std::vector<Facet> facets;
    facets.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) facets.push_back(facet(mesh, corners));
    const auto others = other_sides(mesh.triangles, mesh.vertices.size());
    const double least_cosine = std::cos(angle);
    const auto is_smooth = [&](std::uint32_t side, std::uint32_t other) {
        return glm::dot(facets[side / 3].normal, facets[other / 3].normal) >= least_cosine;
    };
    const auto groups = corner_groups(mesh.triangles, others, is_smooth);

    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<Sum> sums(mesh.vertices.size());
    std::vector<std::uint32_t> vertex_of(groups.size(), none);  // of a group, at its name
    std::vector<bool> is_taken(mesh.vertices.size());
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        std::uint32_t& vertex = mesh.triangles[i / 3][i % 3];
        std::uint32_t& chosen = vertex_of[groups[i]];
        if (chosen == none) {
            chosen = is_taken[vertex] ? add_copy(mesh, sums, vertex) : vertex;
            if (chosen == vertex) is_taken[vertex] = true;
        }
        vertex = chosen;
        sums[vertex].add(facets[i / 3], i % 3);
    }
    set_normals(mesh, sums);
}

void turn_to_normals(Mesh& mesh) {
    for (auto& [i, j, k] : mesh.triangles) {
        const Wide a = mesh.vertices[i];
        const Wide side = glm::cross(Wide(mesh.vertices[j]) - a, Wide(mesh.vertices[k]) - a);
        const Wide normals = Wide(mesh.normals[i]) + Wide(mesh.normals[j]) + Wide(mesh.normals[k]);
        if (glm::dot(side, normals) < 0) std::swap(j, k);
    }
}

}  // namespace rt
