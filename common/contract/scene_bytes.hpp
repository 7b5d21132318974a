// A whole scene as bytes, for the query of a picture. Hierarchies and packed triangles are not
// sent; the receiver builds them again.
#pragma once

#include "common/contract/bytes.hpp"

#include "common/geometry/bounds.hpp"

namespace rt::contract {

inline void put(Writer& to, const PlacedMesh& placed) {
    put(to, placed.model->mesh);
    put(to, placed.placement);
}

inline PlacedMesh get_placed_mesh(Reader& from) {
    Model model;
    model.mesh = get<Mesh>(from);
    model.bounds = bounds(model.mesh);
    if (model.mesh.triangles.size() >= packing_pays_from) model.packed.emplace(model.mesh);
    return {.model = std::make_shared<const Model>(std::move(model)),
            .placement = get<Motion>(from)};
}

template <class Shape>
void put(Writer& to, const Items<Shape>& items) {
    put(to, std::uint32_t(items.size()));
    for (const auto& [shape, material] : items) {
        put(to, shape);
        put(to, material);
    }
}

template <class Shape>
void get_items(Reader& from, Items<Shape>& items) {
    for (auto count = get<std::uint32_t>(from); count > 0; --count) {
        Item<Shape> item;
        if constexpr (std::is_same_v<Shape, PlacedMesh>)
            item.shape = get_placed_mesh(from);
        else
            item.shape = get<Shape>(from);
        item.material = get<Material>(from);
        items.push_back(item);
    }
}

/// The parts of a scene that determine its picture, without the names of files.
inline void put_scene(Writer& to, const Scene& scene) {
    put(to, scene.resolution);
    put(to, scene.cameras);
    put(to, scene.ambient);
    put(to, scene.lights);
    for_each_kind(scene, [&](const auto& items) { put(to, items); });
    put(to, scene.meshes);
}

inline Scene get_scene(Reader& from) {
    Scene scene;
    scene.resolution = get<Resolution>(from);
    scene.cameras = get<std::vector<Camera>>(from);
    scene.ambient = get<std::optional<Ambient>>(from);
    scene.lights = get<std::vector<Light>>(from);
    for_each_kind(scene, [&](auto& items) { get_items(from, items); });
    get_items(from, scene.meshes);
    arrange(scene);
    return scene;
}

}  // namespace rt::contract
