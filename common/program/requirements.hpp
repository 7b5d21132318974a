// The features that a scene requires, and the stages that introduce them.
#pragma once

#include "common/scene/scene.hpp"
#include "common/stages/stages.hpp"

#include <string>
#include <vector>

namespace rt {

/// A feature that a scene requires: "3 spheres", introduced by stage 3.
struct Requirement {
    std::string what;
    int stage = 0;
};

/// Calls visit(material) for each shape, and for each mesh whether its file is read or not.
template <class Visit>
void for_each_material(const Scene& scene, Visit visit) {
    for_each_kind(scene, [&visit](const auto& primitives) {
        for (const auto& primitive : primitives) visit(primitive.material);
    });
    for (const MeshRequest& mesh : scene.mesh_requests) visit(mesh.material);
}

/// Returns the features that a scene requires, sorted by stage. Before stage 9, which introduces
/// light, a torch at the eye replaces everything that concerns light.
[[nodiscard]] std::vector<Requirement> requirements(const Scene& scene, int stage = mesh_stage);

}  // namespace rt
