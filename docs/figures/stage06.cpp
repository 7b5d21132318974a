// Stage 6: a square's own frame, and the one-sided front of the Cornell box.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "common/scene_reader.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step06_square/square.hpp"

namespace rt::figures {

namespace {

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

}  // namespace

std::string square_frame() {
    Svg svg({640, 330},
            "A square and its own frame: x and y from the centre, u and v from a corner");
    const Square square{.center = {0, 0, 0}, .basis = basis_around({0.55, 0.4, 1}), .side = 2};
    const Vec3 eye(-1.2, 0.8, 2.6);
    const Ray ray{.origin = eye, .direction = from_frame(square, 0.55, 0.4) - eye};
    const Vec3 p = first_hit(ray, square);

    Sketch space(svg, looking_along({0.45, -0.3, -1}, {160, 170}, 85));
    draw_square(space, square);
    space.arrow(square.center, square.center + square.basis.x, {.color = green, .width = 2});
    space.arrow(square.center, square.center + square.basis.y, {.color = green, .width = 2});
    space.arrow(square.center, square.center + square.basis.z, {.color = green, .width = 2});
    space.ray(ray, 1);
    space.mark(p, Mark::hit);

    Sketch face(svg,
                {.place = {480, 165}, .scale = 105, .right = square.basis.x, .up = square.basis.y});
    draw_square(face, square);
    face.mark(p, Mark::hit);
    return svg.source();
}

std::string square_one_sided() {
    Svg svg({640, 300}, "The Cornell box from above: the front wall is met from inside only");
    const Scene scene = load_scene(RAYSTEPS_ROOT "/scenes/cornell_box.rt");
    Sketch sketch(svg, {.place = {520, 150}, .scale = 82, .right = {0, 0, -1}, .up = {-1, 0, 0}});
    for (const auto& [square, material] : scene.squares) {
        const Vec3 side = square.basis.x;
        sketch.line(square.center - side, square.center + side, {.width = 3});
    }
    return svg.source();
}

}  // namespace rt::figures
