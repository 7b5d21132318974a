#include "tests/contract/change_scene.hpp"

namespace rt::contract {

namespace {

/// A normal's color has no signs, so that no rotation but that of axes can be undone.
Transform motion_of(const Scene& scene, const RenderSettings& settings, const Change& change) {
    Transform motion = change.any;
    if (settings.shading == Shading::normal)
        motion.rotation = scene.sky ? Basis() : change.exact.rotation;
    else if (scene.sky)
        motion.rotation = change.upright.rotation;
    return motion;
}

template <class Shape>
void transform(PrimitiveList<Shape>& primitives, const Transform& motion, Color dimmed,
               const Change& change) {
    PrimitiveList<Shape> others;
    for (auto [shape, material] : primitives) {
        material.color = dimmed * exchanged(material.color, change);
        others.push_back({.shape = transformed(shape, motion), .material = material});
    }
    primitives = others;
}

}  // namespace

Scene changed(const Scene& scene, const RenderSettings& settings, const Change& change) {
    const Transform motion = motion_of(scene, settings, change);
    const bool is_lit = scene.ambient || !scene.lights.empty();
    const Color of_shapes = is_lit ? Color(1) : change.dimmed;
    Scene other = scene;
    for (Camera& camera : other.cameras) {
        camera.position = rt::transformed(camera.position, motion);
        camera.direction = turned_direction(camera.direction, motion);
    }
    if (other.ambient)
        other.ambient->color = change.dimmed * exchanged(other.ambient->color, change);
    for (Light& light : other.lights) {
        light.position = rt::transformed(light.position, motion);
        light.radius *= motion.scale;
        light.color = change.dimmed * exchanged(light.color, change);
    }
    if (other.sky && settings.shading != Shading::normal)
        for (Color* const color : {&other.sky->bottom, &other.sky->top})
            *color = change.dimmed * exchanged(*color, change);
    for_each_kind(other,
                  [&](auto& primitives) { transform(primitives, motion, of_shapes, change); });
    transform(other.meshes, motion, of_shapes, change);
    return other;
}

Color changed_back(Color color, const Scene& scene, const RenderSettings& settings,
                   const Change& change) {
    if (settings.shading == Shading::normal)
        return abs(turned_back(color, motion_of(scene, settings, change)));
    return exchanged_back(color / change.dimmed, change);
}

}  // namespace rt::contract
