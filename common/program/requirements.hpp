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

// The text that `--requirements` prints about a scene.

/// A visible error of a picture with the default settings, and the option that reduces it.
struct Advice {
    std::string seen;   ///< its cause in the scene: "a lamp with a size"
    std::string wrong;  ///< the error in the picture: "grain"
    std::string mends;  ///< the option
    std::string costs;  ///< the price of the option, in time or rays
};

/// Returns the rows of the table in docs/reference/accuracy.md that apply to the scene, as far as
/// it can be seen without its meshes' files.
[[nodiscard]] std::vector<Advice> advice(const Scene& scene);

/// Returns the lines that `--requirements` prints: the scene's requirements, the parts that this
/// program therefore omits, and the advice, each row in at most 80 columns.
[[nodiscard]] std::string explanation(const Scene& scene);

}  // namespace rt
