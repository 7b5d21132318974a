#include "common/program/requirements.hpp"

#include <algorithm>

namespace rt {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// The number of materials in the scene that satisfy the predicate.
template <class Predicate>
std::size_t materials(const Scene& scene, Predicate is) {
    std::size_t count = 0;
    for_each_material(scene, [&](const Material& material) { count += is(material) ? 1 : 0; });
    return count;
}

}  // namespace

std::vector<Requirement> requirements(const Scene& scene, int stage) {
    std::vector<Requirement> found;
    const auto require = [&found](std::size_t count, int needed, const std::string& one,
                                  const std::string& many) {
        if (count > 0) found.push_back({.what = counted(count, one, many), .stage = needed});
    };
    const auto require_shapes = [&](int from, int before) {
        const auto of_kind = [&](const auto& kind) {
            if (kind.stage >= from && kind.stage < before)
                require((scene.*kind.primitives).size(), kind.stage, kind.one, kind.many);
        };
        std::apply([&](const auto&... kind) { (of_kind(kind), ...); }, shape_kinds);
    };
    require(scene.sky ? 1 : 0, shapes_stage, "sky", "");
    require_shapes(0, light_stage);
    if (stage >= light_stage) {
        const auto shines = [](const Material& material) { return material.specular > 0; };
        const auto has_size = [](const Light& light) { return light.radius > 0; };
        const auto sized = std::ranges::count_if(scene.lights, has_size);
        require(scene.ambient ? 1 : 0, light_stage, "ambient light", "");
        require(scene.lights.size(), light_stage, "light", "lights");
        require(materials(scene, shines), light_stage, "shape with a highlight",
                "shapes with a highlight");
        require(std::size_t(sized), soft_shadow_stage, "light with a size", "lights with a size");
    }
    const auto reflects = [](const Material& material) { return material.mirror > 0; };
    require(materials(scene, reflects), mirror_stage, "mirror", "mirrors");
    require_shapes(light_stage, int(stage_names.size()) + 1);
    require(scene.mesh_requests.size(), mesh_stage, "mesh", "meshes");
    return found;
}

}  // namespace rt
