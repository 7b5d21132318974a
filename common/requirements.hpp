// What a scene requires, and which stage brings it.
#pragma once

#include "common/scene.hpp"
#include "common/stages.hpp"

#include <string>
#include <vector>

namespace rt {

/// Something a scene asks for: "3 spheres", brought by stage 3.
struct Requirement {
    std::string what;
    int stage = 0;
};

/// What must be there for the scene to be drawn, in the order of the stages. Before stage 9, which
/// brings light, a torch at the eye takes the place of whatever has to do with it.
[[nodiscard]] std::vector<Requirement> requirements(const Scene& scene, int stage = mesh_stage);

/// What the scene requires, and what is therefore left out: the lines of `--explain`.
[[nodiscard]] std::string explanation(const Scene& scene);

}  // namespace rt
