// The meshes of this suite, and their text.
#pragma once

#include "steps/step13_meshes/meshes.hpp"

#include "common/explain/text.hpp"
#include "tests/kit/meshes.hpp"

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

}  // namespace rt
