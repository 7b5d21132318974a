// Stage 1: the pixels on the screen, and the screen from the side.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt::figures {

namespace {

constexpr Resolution resolution{.width = 6, .height = 4};
constexpr Real fov = pi / 3;

/// On the screen, z = −1.
Vec3 center_of(Pixel pixel) {
    return Vec3(pixel_on_screen(pixel, resolution, fov), -1);
}

/// The upper left corner of a pixel, half-way between two centres.
Vec3 corner_of(Pixel pixel) {
    return (center_of({pixel.row - 1, pixel.column - 1}) + center_of(pixel)) / Real(2);
}

void draw_cells(Sketch& sketch, Pixel chosen) {
    const auto [row, column] = chosen;
    sketch.polygon({corner_of(chosen), corner_of({row, column + 1}),
                    corner_of({row + 1, column + 1}), corner_of({row + 1, column})},
                   tint, no_pen);
    const auto [width, height] = resolution;
    for (int i = 0; i <= height; ++i) sketch.line(corner_of({i, 0}), corner_of({i, width}), thin);
    for (int j = 0; j <= width; ++j) sketch.line(corner_of({0, j}), corner_of({height, j}), thin);
    for (int i = 0; i < height; ++i)
        for (int j = 0; j < width; ++j) sketch.mark(center_of({i, j}), Mark::foot);
    sketch.mark(center_of(chosen), Mark::hit);
}

void draw_counts(Sketch& sketch) {
    const auto [width, height] = resolution;
    for (int j = 0; j < width; ++j)
        sketch.label({center_of({0, j}).x, corner_of({0, 0}).y, -1}, {0, -10}, std::to_string(j));
    for (int i = 0; i < height; ++i)
        sketch.label({corner_of({0, 0}).x, center_of({i, 0}).y, -1}, {-16, 5}, std::to_string(i));
    sketch.measure(corner_of({0, 0}), corner_of({0, width}), {0, -34});
    sketch.label(corner_of({0, width / 2}), {0, -41}, "$W$ = 6 columns, $j$ from the left");
    sketch.measure(corner_of({0, 0}), corner_of({height, 0}), {-34, 0});
    sketch.label(corner_of({height / 2, 0}), {-44, -24}, "$H$ = 4", {.anchor = Anchor::end});
    sketch.label(corner_of({height / 2, 0}), {-44, -4}, "rows,", {.anchor = Anchor::end});
    sketch.label(corner_of({height / 2, 0}), {-44, 14}, "$i$ from", {.anchor = Anchor::end});
    sketch.label(corner_of({height / 2, 0}), {-44, 32}, "the top", {.anchor = Anchor::end});
}

void draw_axes(Sketch& sketch) {
    const Vec3 middle = corner_of({resolution.height / 2, resolution.width / 2});
    const Vec3 top_right = corner_of({0, resolution.width});
    const TextStyle style{.anchor = Anchor::start};
    sketch.arrow(middle, {top_right.x + Real(0.1), middle.y, -1});
    sketch.arrow(middle, {middle.x, top_right.y + Real(0.08), -1});
    sketch.label({top_right.x, middle.y, -1}, {28, 5}, "$x$", style);
    sketch.label({middle.x, top_right.y, -1}, {6, -9}, "$y$", style);
    sketch.label(top_right, {10, 5}, "$y$ = tan(FOV / 2)", style);
    sketch.label(corner_of({resolution.height, resolution.width}), {10, 5}, "$y$ = −tan(FOV / 2)",
                 style);
}

/// The columns in one of the coordinates that MRT passes through: a line under the grid.
void draw_ruler(Sketch& sketch, Real below, std::string_view name, Real left, Real right,
                Pixel chosen, int decimals) {
    const Real bottom = corner_of({resolution.height, 0}).y - below;
    const auto on_ruler = [bottom](Vec3 p) { return Vec3(p.x, bottom, -1); };
    const Vec3 begin = on_ruler(corner_of({0, 0}));
    const Vec3 end = on_ruler(corner_of({0, resolution.width}));
    const Vec3 here = on_ruler(center_of(chosen));
    sketch.line(begin, end);
    for (int j = 0; j <= resolution.width; ++j) {
        const Vec3 tick = on_ruler(corner_of({0, j}));
        sketch.line(tick - Vec3(0, 0.015, 0), tick + Vec3(0, 0.015, 0));
    }
    const Real share = (here.x - begin.x) / (end.x - begin.x);
    sketch.mark(here, Mark::hit);
    sketch.label(begin, {-8, 5}, decimal(left, left == std::round(left) ? 0 : decimals),
                 {.anchor = Anchor::end, .size = 13});
    sketch.label(end, {8, 5}, decimal(right, right == std::round(right) ? 0 : decimals),
                 {.anchor = Anchor::start, .size = 13});
    sketch.label(here, {0, -8}, decimal(left + share * (right - left), decimals),
                 {.color = red, .size = 13});
    sketch.label(end, {56, 5}, name, {.anchor = Anchor::start});
}

}  // namespace

std::string pixel_grid() {
    Svg svg({640, 520}, "The pixels of a picture of 6 by 4 on the screen, and their coordinates");
    Sketch sketch(svg, {.place = {290, 196}, .scale = 215});
    constexpr Pixel chosen{.row = 1, .column = 4};
    const Vec3 here = center_of(chosen);
    const Vec3 edge = corner_of({0, resolution.width});
    draw_cells(sketch, chosen);
    draw_counts(sketch);
    draw_axes(sketch);
    sketch.line(here, {here.x, corner_of({resolution.height, 0}).y - Real(0.8), -1},
                {.color = red, .width = 1, .dashes = "3 4"});
    sketch.label(edge, {10, 74}, "$i$ = 1, $j$ = 4: pixFinal =",
                 {.color = red, .anchor = Anchor::start, .size = 13});
    sketch.label(edge, {10, 92}, "(" + decimal(here.x, 3) + ", " + decimal(here.y, 3) + ")",
                 {.color = red, .anchor = Anchor::start, .size = 13});
    draw_ruler(sketch, Real(0.17), "$j$ + 0.5", 0, resolution.width, chosen, 1);
    draw_ruler(sketch, Real(0.35), "$pixNorm_x$", 0, 1, chosen, 2);
    draw_ruler(sketch, Real(0.53), "$pixScreen_x$", -1, 1, chosen, 2);
    draw_ruler(sketch, Real(0.71), "$pixFinal_x$", -edge.x, edge.x, chosen, 3);
    return svg.source();
}

std::string screen_fov() {
    Svg svg({640, 430}, "The screen at z = −1 from the side, with the field of view");
    Sketch sketch(svg, {.place = {96, 208}, .scale = 172, .right = {0, 0, -1}});
    const Vec3 top = Vec3(0, corner_of({0, 0}).y, -1);
    const Vec3 bottom = Vec3(0, corner_of({resolution.height, 0}).y, -1);
    const Vec3 eye = camera_ray({0, 0}, resolution, fov).origin;

    sketch.polygon({eye, Real(2.15) * top, Real(2.15) * bottom}, tint, no_pen);
    sketch.line(eye, Real(2.15) * top, dashed);
    sketch.line(eye, Real(2.15) * bottom, dashed);
    sketch.line(Real(2) * top, Real(2) * bottom, dashed);
    sketch.arrow({0, 0, 0.35}, {0, 0, -2.8}, thin);
    sketch.label({0, 0, -2.8}, {8, 5}, "$−z$", {.anchor = Anchor::start});

    for (int i = 0; i < resolution.height; ++i) {
        Ray ray = camera_ray({i, 0}, resolution, fov);
        ray.direction.x = 0;  // seen from the side, the columns stand one behind the other
        sketch.ray(ray, Real(2.4));
        sketch.mark(at(ray, 1), Mark::hit);
        sketch.mark(at(ray, 2), Mark::foot);
        sketch.label(at(ray, Real(2.4)), {8, 5}, "$i$ = " + std::to_string(i),
                     {.color = blue, .anchor = Anchor::start});
    }
    sketch.line(top, bottom, {.width = 3});
    for (int i = 0; i < resolution.height; ++i)
        sketch.mark({0, center_of({i, 0}).y, -1}, Mark::hit);
    for (int i = 0; i <= resolution.height; ++i) {
        const Vec3 corner(0, corner_of({i, 0}).y, -1);
        sketch.line(corner + Vec3(0, 0, 0.02), corner - Vec3(0, 0, 0.02));
    }
    sketch.mark(eye, Mark::given);
    sketch.label(eye, {-6, -10}, "$o_r$", {.anchor = Anchor::end});
    sketch.angle(eye, top, bottom, 52, {.width = 1.2});
    sketch.label(eye, {62, -8}, "FOV", {.anchor = Anchor::start});
    sketch.measure({0, 0, -1}, top, {-16, 0});
    sketch.label({0, top.y / 2, -1}, {-22, 8}, "tan(FOV / 2)", {.anchor = Anchor::end});
    sketch.label(top, {0, -14}, "the screen: $z$ = −1, $t$ = 1");
    sketch.label(Real(2) * top, {0, -6}, "$t$ = 2");
    sketch.measure(eye, {0, 0, -1}, {0, 150});
    sketch.label({0, 0, -0.5}, {0, 168}, "1");
    return svg.source();
}

}  // namespace rt::figures
