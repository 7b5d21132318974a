#include "common/mesh_loading.hpp"

#include "common/mesh_normals.hpp"
#include "common/mesh_reader.hpp"

#include <filesystem>
#include <map>
#include <utility>

namespace rt {

namespace {

std::shared_ptr<const Model> load_model(const std::string& file, bool smooth) {
    Model model{.mesh = load_mesh(file)};
    Mesh& mesh = model.mesh;
    if (!smooth) mesh.normals.clear();
    if (smooth && mesh.normals.empty()) mesh.normals = smooth_normals(mesh);
    if (mesh.triangles.size() >= packing_pays_from) model.packed.emplace(mesh);
    model.bounds = model.packed ? model.packed->bounds() : bounds(mesh);
    return std::make_shared<const Model>(std::move(model));
}

}  // namespace

void load_meshes(Scene& scene) {
    std::map<std::pair<std::string, bool>, std::shared_ptr<const Model>> models;
    for (const NamedMesh& named : scene.named_meshes) {
        // As the scene's folder sees it, wherever the program runs.
        const auto folder = std::filesystem::path(named.place.file).parent_path();
        const std::string file = (folder / named.file).string();
        auto& model = models[{file, named.smooth}];
        if (!model) model = load_model(file, named.smooth);
        scene.meshes.push_back(
            {.shape = {.model = model, .placement = named.placement}, .material = named.material});
    }
}

}  // namespace rt
