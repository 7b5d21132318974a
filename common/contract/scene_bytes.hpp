// A whole scene as bytes, for the query of a picture. Hierarchies and packed triangles are not
// sent; the receiver builds them again.
#pragma once

#include "common/contract/bytes.hpp"
#include "common/geometry/bounds.hpp"

namespace rt::contract {

inline void put(Writer& to, const MeshInstance& instance) {
    put(to, instance.model->mesh);
    put(to, instance.placement);
}

inline MeshInstance get_placed_mesh(Reader& from) {
    // Braces keep the order.
    return {.model = mesh_geometry(get<Mesh>(from)), .placement = get<Transform>(from)};
}

template <class Shape>
void put(Writer& to, const PrimitiveList<Shape>& primitives) {
    put(to, std::uint32_t(primitives.size()));
    for (const auto& [shape, material] : primitives) {
        put(to, shape);
        put(to, material);
    }
}

template <class Shape>
void get_items(Reader& from, PrimitiveList<Shape>& primitives) {
    for (auto count = get<std::uint32_t>(from); count > 0; --count) {
        Primitive<Shape> primitive;
        if constexpr (std::is_same_v<Shape, MeshInstance>)
            primitive.shape = get_placed_mesh(from);
        else
            primitive.shape = get<Shape>(from);
        primitive.material = get<Material>(from);
        primitives.push_back(primitive);
    }
}

/// The parts of a scene that determine its picture, without the names of files.
inline void put_scene(Writer& to, const Scene& scene) {
    put(to, scene.resolution);
    put(to, scene.cameras);
    put(to, scene.ambient);
    put(to, scene.lights);
    put(to, scene.sky);
    for_each_kind(scene, [&](const auto& primitives) { put(to, primitives); });
    put(to, scene.meshes);
}

inline Scene get_scene(Reader& from) {
    Scene scene;
    scene.resolution = get<Resolution>(from);
    scene.cameras = get<std::vector<Camera>>(from);
    scene.ambient = get<std::optional<Ambient>>(from);
    scene.lights = get<std::vector<Light>>(from);
    scene.sky = get<std::optional<Sky>>(from);
    for_each_kind(scene, [&](auto& primitives) { get_items(from, primitives); });
    get_items(from, scene.meshes);
    // As stages 3 to 8 draw it: a wrong hit outside of the shape's bounding sphere is seen.
    build_acceleration(scene, {.balls = false});
    return scene;
}

}  // namespace rt::contract
