// What a scene requires, and which stage brings it.
#pragma once

#include "common/scene.hpp"

#include <string>
#include <vector>

namespace rt {

/// Something a scene asks for: "3 spheres", brought by stage 3.
struct Requirement {
    std::string what;
    int stage = 0;
};

/// What must be there for the scene to be drawn, in the order of the stages. Lights are not among
/// them before stage 9: until then a torch at the eye takes their place.
[[nodiscard]] std::vector<Requirement> requirements(const Scene& scene);

}  // namespace rt
