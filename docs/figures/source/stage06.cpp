// Stage 6: the one-sided front of the Cornell box.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/scene_file/reader.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step06_square/square.hpp"

namespace rt::figures {

namespace {

/// The scene's upright walls, which a level cut shows as lines.
std::vector<Square> upright_walls(const Scene& scene) {
    std::vector<Square> walls;
    for (const Primitive<Square>& primitive : scene.squares)
        if (primitive.shape.basis.z.y == 0) walls.push_back(primitive.shape);
    return walls;
}

/// The ray as far as the wall it hits, with a ring where a wall that it would hit from behind
/// lets it through.
void draw_ray_in_box(Sketch& sketch, const Ray& ray, const std::vector<Square>& walls) {
    Interval interval;
    for (const Square& wall : walls)
        if (const auto t = intersect(ray, wall, interval)) interval.max = *t;
    sketch.ray(ray, interval.max);
    sketch.mark(at(ray, interval.max), Mark::hit);
    for (Square wall : walls) {
        if (intersect(ray, wall, {})) continue;
        wall.one_sided = false;
        if (const auto t = intersect(ray, wall, interval)) sketch.mark(at(ray, *t), Mark::refused);
    }
}

void draw_walls(Sketch& sketch, const std::vector<Square>& walls) {
    for (const Square& wall : walls) {
        const Vec3 half = wall.side / 2 * wall.basis.x;
        const std::string_view dashes = wall.one_sided ? "9 6" : "";
        sketch.line(wall.center - half, wall.center + half, {.width = 3, .dashes = dashes});
        sketch.normal(wall.center, normal(wall, wall.center), 30);
        sketch.label(wall.center, Real(40) * Vec2(-wall.basis.z.z, wall.basis.z.x) + Vec2(0, 5),
                     "$n$", {.color = green});
    }
}

void label_box(Svg& svg, Sketch& sketch, Vec3 eye) {
    const TextStyle note{.anchor = Anchor::start, .size = 13};
    sketch.label(eye, {-12, 5}, "$o_r$", {.anchor = Anchor::end});
    sketch.label({-1, 0, 1}, {0, -12}, "the front, one-sided");
    sketch.label({-1, 0, -1}, {0, -12}, "the back");
    Sketch key(svg, {.place = {28, 283}, .scale = 1});
    key.mark({0, 0, 0}, Mark::refused);
    key.label({0, 0, 0}, {12, 5}, "⟨$d_r$, $n$⟩ > 0: one looks through", note);
    key.mark({0, -24, 0}, Mark::hit);
    key.label({0, -24, 0}, {12, 5}, "⟨$d_r$, $n$⟩ < 0: a hit", note);
}

}  // namespace

std::string cornell_from_above() {
    Svg svg({640, 330}, "The Cornell box from above: the front wall is hit from inside only");
    const Scene scene = load_scene(RAYSTEPS_ROOT "/scenes/cornell_box.rt", orthonormal_basis);
    const std::vector<Square> walls = upright_walls(scene);
    const Camera& camera = scene.cameras.front();
    const Basis basis = camera_basis(camera.direction);
    Sketch sketch(svg, {.place = {430, 160}, .scale = 120, .right = {0, 0, -1}, .up = {-1, 0, 0}});
    sketch.polygon({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, tint, no_pen);
    draw_walls(sketch, walls);
    const auto [width, height] = scene.resolution;
    const Real fov = vertical_fov(camera, scene.resolution);
    for (int j = width / 12; j < width; j += width / 6) {
        const Ray ray = camera_ray({height / 2, j}, scene.resolution, fov);
        draw_ray_in_box(sketch, to_world(ray, basis, camera.position), walls);
    }
    const Ray from_inside{.origin = {-0.2, 0, -0.55}, .direction = {-0.3, 0, 1}};
    draw_ray_in_box(sketch, from_inside, walls);
    sketch.mark(from_inside.origin, Mark::given);
    sketch.mark(camera.position, Mark::given);
    label_box(svg, sketch, camera.position);
    return svg.source();
}

}  // namespace rt::figures
