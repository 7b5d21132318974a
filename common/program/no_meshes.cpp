#include "common/program/load_meshes.hpp"

#include "common/stages/stages.hpp"

namespace rt {

void load_meshes(Scene& scene, const Warn& /*warn*/) {
    if (scene.mesh_requests.empty()) return;
    throw InputError(scene.mesh_requests.front().place,
                     "a mesh, which " + name_of(mesh_stage) + " introduces: run that stage");
}

std::string mesh_forms(const Scene& /*scene*/, const Warn& /*warn*/) {
    return "";
}

}  // namespace rt
