#include "tests/contract/change_scene.hpp"

#include <cmath>

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

Scene enlarged(const Scene& scene, const Change& change) {
    bool has_shapes = !scene.meshes.empty();
    for_each_kind(scene, [&](const auto& primitives) { has_shapes |= !primitives.empty(); });
    if (has_shapes) return scene;
    Scene other = scene;
    const auto [width, height] = scene.resolution;
    other.resolution = {.width = width + 2 * change.margin.column,
                        .height = height + 2 * change.margin.row};
    const Real larger = Real(other.resolution.height) / Real(height);
    for (Camera& camera : other.cameras) {
        const Real fov = vertical_fov(camera, scene.resolution);
        camera.fov = 2 * std::atan(larger * std::tan(fov / 2));
        camera.fov_axis = FovAxis::vertical;
    }
    return other;
}

Image middle_of(const Image& picture, Resolution size) {
    const Pixel first{.row = (picture.resolution.height - size.height) / 2,
                      .column = (picture.resolution.width - size.width) / 2};
    Image middle(size);
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column)
            middle[pixel] =
                picture[{.row = first.row + pixel.row, .column = first.column + pixel.column}];
    return middle;
}

}  // namespace rt::contract
