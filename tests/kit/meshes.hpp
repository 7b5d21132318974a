// Closed meshes for the tests.
#pragma once

#include "common/geometry/mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rt {

/// The octahedron with its vertices on the axes, at distance 1.
inline Mesh octahedron() {
    return {.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            .normals = {},
            .triangles = {{0, 2, 4},
                          {2, 1, 4},
                          {1, 3, 4},
                          {3, 0, 4},
                          {2, 0, 5},
                          {1, 2, 5},
                          {3, 1, 5},
                          {0, 3, 5}}};
}

/// Four triangles for one, and the vertices on the unit sphere.
inline Mesh refined(const Mesh& mesh) {
    Mesh finer{.vertices = mesh.vertices, .normals = {}, .triangles = {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t p, std::uint32_t q) {
        const auto [found, is_new] =
            middles.try_emplace(std::minmax(p, q), std::uint32_t(finer.vertices.size()));
        if (is_new) finer.vertices.push_back(normalize(mesh.vertices[p] + mesh.vertices[q]));
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        finer.triangles.insert(finer.triangles.end(),
                               {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return finer;
}

}  // namespace rt
