#include "tests/contract/change.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/seed.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace rt::contract {

namespace {

std::optional<Change>& of_case() {
    static std::optional<Change> change;
    return change;
}

/// 1/8 to 8, but 1: whatever has a size is another.
Real draw_power(Random& random) {
    const Real power = std::ldexp(Real(1), 1 + random.below(3));
    return random.coin() ? power : 1 / power;
}

Basis draw_upright(Random& random, bool exact) {
    const int quarters = random.below(4);
    constexpr std::array<int, 4> cosines{1, 0, -1, 0};
    const Real angle = random.between(-pi, pi);
    const Real c = exact ? Real(cosines[std::size_t(quarters)]) : std::cos(angle);
    const Real s = exact ? Real(cosines[std::size_t((quarters + 3) % 4)]) : std::sin(angle);
    return {.x = {c, 0, -s}, .y = {0, 1, 0}, .z = {s, 0, c}};
}

Change draw(Random& random, bool exact) {
    Change change;
    change.exact = {.rotation = random.axes(), .scale = draw_power(random)};
    change.any.rotation = random.basis();
    change.any.scale = random.between(Real(0.4), Real(2.5));
    change.any.translation = change.any.scale * random.point(2);
    change.length = exact ? draw_power(random) : random.between(Real(0.4), Real(2.5));
    change.light = exact ? 1 / (1 + std::abs(draw_power(random))) : random.between(Real(0.3), 1);
    if (exact) change.light = power_of_two_below(change.light);
    if (exact) change.any = change.exact;
    change.boxes = change.any;
    change.boxes.rotation = change.exact.rotation;
    change.upright = {.rotation = draw_upright(random, exact), .scale = change.any.scale};
    std::swap(change.channels[0], change.channels[std::size_t(random.below(3))]);
    std::swap(change.channels[1], change.channels[std::size_t(1 + random.below(2))]);
    change.finer = 3 + 2 * random.below(8);
    change.zoom = random.between(Real(0.5), 2);
    for (int i = 0; i < 3; ++i) change.dimmed[i] = random.between(Real(0.3), 1);
    change.margin = {.row = 1 + random.below(12), .column = 1 + random.below(12)};
    return change;
}

}  // namespace

const Change* change() {
    return of_case() && !is_drawn() ? &*of_case() : nullptr;
}

void draw_change(const std::string& name, bool exact) {
    of_case().reset();
    if (!seed().secret || std::getenv("RAYSTEPS_AS_WRITTEN") != nullptr) return;
    Random random(draw_number(seed().number, "the change of " + name, 0));
    of_case() = draw(random, exact);
}

Vec3 turned_direction(Vec3 v, const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    const std::array<Vec3, 3> axes{x, y, z};
    Vec3 result;
    for (glm::length_t k = 0; k < 3; ++k) {
        Real sum = -Real(0);
        for (glm::length_t i = 0; i < 3; ++i)
            if (axes[std::size_t(i)][k] != 0) sum += v[i] * axes[std::size_t(i)][k];
        result[k] = sum;
    }
    return result;
}

Vec3 turned_back(Vec3 v, const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    return {dot(v, x), dot(v, y), dot(v, z)};
}

Vec3 moved_back(Vec3 point, const Transform& transform) {
    return turned_back(point - transform.translation, transform) / transform.scale;
}

Ray transformed(const Ray& ray, const Transform& transform, Real length) {
    return {.origin = rt::transformed(ray.origin, transform),
            .direction = length * transform.scale * turned_direction(ray.direction, transform)};
}

Ray moved_back(const Ray& ray, const Transform& transform, Real length) {
    return {.origin = moved_back(ray.origin, transform),
            .direction = turned_back(ray.direction, transform) / (length * transform.scale)};
}

Interval divided(Interval interval, Real length) {
    return {.min = interval.min / length, .max = interval.max / length};
}

BoundingBox transformed(const BoundingBox& box, const Transform& transform) {
    const Vec3 a = rt::transformed(box.min, transform);
    const Vec3 b = rt::transformed(box.max, transform);
    return {.min = min(a, b), .max = max(a, b)};
}

Mesh transformed(Mesh mesh, const Transform& transform) {
    for (Vec3& vertex : mesh.vertices) vertex = rt::transformed(vertex, transform);
    for (Vec3& normal : mesh.normals) normal = rt::rotated(normal, transform);
    return mesh;
}

Transform transformed(const Transform& placement, const Transform& transform) {
    return {.rotation = rt::rotated(placement.rotation, transform),
            .scale = transform.scale * placement.scale,
            .translation = rt::transformed(placement.translation, transform)};
}

MeshInstance transformed(const MeshInstance& mesh, const Transform& transform) {
    return {.model = mesh.model, .placement = transformed(mesh.placement, transform)};
}

Mat4 matrix_of(const Transform& transform) {
    const auto& [x, y, z] = transform.rotation;
    return {Vec4(transform.scale * x, 0), Vec4(transform.scale * y, 0),
            Vec4(transform.scale * z, 0), Vec4(transform.translation, 1)};
}

Color exchanged(Color color, const Change& change) {
    Color result;
    for (int i = 0; i < 3; ++i) result[change.channels[std::size_t(i)]] = color[i];
    return result;
}

Color exchanged_back(Color color, const Change& change) {
    Color result;
    for (int i = 0; i < 3; ++i) result[i] = color[change.channels[std::size_t(i)]];
    return result;
}

ShadingPoint changed(ShadingPoint surface, const Change& change, const Transform& transform) {
    surface.point = rt::transformed(surface.point, transform);
    for (Vec3* const direction : {&surface.normal, &surface.geometric_normal, &surface.to_eye})
        *direction = turned_direction(*direction, transform);
    surface.error *= transform.scale;
    surface.material.color = exchanged(surface.material.color, change);
    return surface;
}

Light changed(Light light, const Change& change, const Transform& transform) {
    light.position = rt::transformed(light.position, transform);
    light.radius *= transform.scale;
    light.brightness *= change.light;
    light.color = exchanged(light.color, change);
    return light;
}

Ambient changed(Ambient light, const Change& change, const Transform& /*transform*/) {
    light.ratio *= change.light;
    light.color = exchanged(light.color, change);
    return light;
}

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
