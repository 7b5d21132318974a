// The meshes of this suite, and their text.
#pragma once

#include "steps/step13_meshes/meshes.hpp"

#include "common/explain/text.hpp"

#include <optional>
#include <string>

namespace rt {

/// C++ that creates the mesh.
inline std::string mesh_code(const Mesh& mesh) {
    std::string vertices;
    for (const Vec3& v : mesh.vertices) vertices += (vertices.empty() ? "" : ", ") + code(v);
    std::string triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles += std::string(triangles.empty() ? "" : ", ") + "{" + std::to_string(a) + ", " +
                     std::to_string(b) + ", " + std::to_string(c) + "}";
    return "Mesh{.vertices = {" + vertices + "}, .triangles = {" + triangles + "}}";
}

inline std::string got_text(const std::optional<MeshHit>& hit) {
    return hit ? "triangle " + std::to_string(hit->triangle) + " at t = " + text(hit->t) +
                     ", weights " + text(hit->weights)
               : "no hit";
}

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

}  // namespace rt
