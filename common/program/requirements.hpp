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

/// Returns the features that a scene requires, sorted by stage. Before stage 9, which introduces
/// light, a torch at the eye replaces everything that concerns light.
[[nodiscard]] std::vector<Requirement> requirements(const Scene& scene, int stage = mesh_stage);

}  // namespace rt
