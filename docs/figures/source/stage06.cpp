// Stage 6: a square's own frame, and the one-sided front of the Cornell box.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/scene_file/reader.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step06_square/square.hpp"

namespace rt::figures {

namespace {

constexpr Pen axis{.color = green, .width = 2};

/// The point of the square's plane with these coordinates in its own frame.
Vec3 from_frame(const Square& square, Real x, Real y) {
    return square.center + x * square.basis.x + y * square.basis.y;
}

void draw_square(Sketch& sketch, const Square& square) {
    const Real half = square.side / 2;
    sketch.polygon({from_frame(square, -half, -half), from_frame(square, half, -half),
                    from_frame(square, half, half), from_frame(square, -half, half)},
                   tint);
}

void draw_in_space(Svg& svg, Vec2 place, const Square& square, const Ray& ray) {
    Sketch sketch(svg, looking_along({-0.25, -0.4, -1}, place, 88));
    const Vec3 o = square.center;
    const Vec3 p = first_hit(ray, square);
    const auto& [x, y, z] = square.basis;
    draw_square(sketch, square);
    sketch.arrow(o, o + x, axis);
    sketch.arrow(o, o + y, axis);
    sketch.arrow(o, o + Real(1.3) * normal(square, p), axis);
    sketch.ray(ray, 1);
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(o, Mark::given);
    sketch.mark(p, Mark::hit);
    const TextStyle style{.color = green};
    sketch.label(o + x, {12, 10}, "$X$", style);
    sketch.label(o + y, {4, -8}, "$Y$", style);
    sketch.label(o + Real(1.3) * z, {-11, 5}, "$Z$", style);
    sketch.label(o, {6, 19}, "$o$");
    sketch.label(ray.origin, {-4, -12}, "$o_r$");
    sketch.label(p, {12, -6}, "$p$", {.color = red});
}

/// Seen from the front: x and y from the center, u and v from the corner C.
void draw_face(Svg& svg, Vec2 place, const Square& square, Vec3 p) {
    Sketch sketch(svg,
                  {.place = place, .scale = 105, .right = square.basis.x, .up = square.basis.y});
    const Real half = square.side / 2;
    const Real x = dot(p - square.center, square.basis.x);
    const Real y = dot(p - square.center, square.basis.y);
    const Vec2 uv = square_uv(square, p);
    const Vec3 corner = from_frame(square, -half, -half);
    const auto at_frame = [&square](Real a, Real b) { return from_frame(square, a, b); };

    draw_square(sketch, square);
    sketch.line(at_frame(x, -half), p, dashed);
    sketch.line(at_frame(-half, y), p, dashed);
    sketch.arrow(square.center, at_frame(half, 0), axis);
    sketch.arrow(square.center, at_frame(0, half), axis);
    sketch.arrow(corner, at_frame(half, -half), {.width = 2.2});
    sketch.arrow(corner, at_frame(-half, half), {.width = 2.2});
    sketch.measure(at_frame(0, half), at_frame(half, half), {0, -14});
    sketch.measure(corner, at_frame(x, -half), {0, 14});
    sketch.measure(corner, at_frame(-half, y), {-14, 0});
    sketch.mark(square.center, Mark::given);
    sketch.mark(corner, Mark::given);
    sketch.mark(p, Mark::hit);

    const TextStyle of_axis{.color = green};
    const TextStyle after{.anchor = Anchor::start};
    sketch.label(at_frame(half, 0), {14, 5}, "$X$", of_axis);
    sketch.label(at_frame(0, half), {-12, 16}, "$Y$", of_axis);
    sketch.label(square.center, {-10, 17}, "$o$");
    sketch.label(p, {12, -6}, "$p$", {.color = red});
    sketch.label(at_frame(x / 2, 0), {6, 18}, "$x$ = " + decimal(x, 1), {.size = 13});
    sketch.label(at_frame(0, y / 2), {-8, 5}, "$y$ = " + decimal(y, 1),
                 {.anchor = Anchor::end, .size = 13});
    sketch.label(at_frame(half / 2, half), {0, -20}, "$h$ / 2");
    sketch.label(at_frame((x - half) / 2, -half), {0, 32}, "$u$ = " + decimal(uv.x, 2));
    sketch.label(at_frame(-half, (y - half) / 2), {-21, 5}, "$v$ = " + decimal(uv.y, 2),
                 {.anchor = Anchor::end});
    sketch.label(corner, {-8, 16}, "$C$");
    sketch.label(at_frame(half, -half), {6, 5}, "$U$", after);
    sketch.label(at_frame(-half, half), {0, -6}, "$V$");
}

}  // namespace

std::string square_frame() {
    Svg svg({640, 320},
            "A square and its own frame: x and y from the center, u and v from a corner");
    const Square square{
        .center = {0, 0, 0}, .basis = orthonormal_basis({-0.5, 0.3, 0.85}), .side = 2};
    const Vec3 eye(-1.2, 1.35, 1.7);
    const Ray ray{.origin = eye, .direction = from_frame(square, 0.5, 0.4) - eye};
    draw_in_space(svg, {176, 168}, square, ray);
    draw_face(svg, {488, 156}, square, first_hit(ray, square));
    return svg.source();
}

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
