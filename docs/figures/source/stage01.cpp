// Stage 1: the pixels on the screen.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

namespace rt::figures {

namespace {

constexpr Resolution resolution{.width = 6, .height = 4};
constexpr Real fov = pi / 3;

/// On the screen, z = −1.
Vec3 center_of(Pixel pixel) {
    return Vec3(pixel_on_screen(pixel, resolution, fov), -1);
}

/// The upper left one.
Vec3 corner_of(Pixel pixel) {
    return at(corner_ray(pixel, resolution, fov), 1);
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
    const Vec3 middle = corner_of({height / 2, 0});
    sketch.label(middle, {-44, -24}, "$H$ = 4", {.anchor = Anchor::end});
    sketch.label(middle, {-44, -5}, "rows,", {.anchor = Anchor::end});
    sketch.label(middle, {-44, 14}, "$i$ from", {.anchor = Anchor::end});
    sketch.label(middle, {-44, 33}, "the top", {.anchor = Anchor::end});
}

void draw_axes(Sketch& sketch) {
    const Vec3 middle = corner_of({resolution.height / 2, resolution.width / 2});
    const Vec3 top_right = corner_of({0, resolution.width});
    const Vec3 bottom_right = corner_of({resolution.height, resolution.width});
    const TextStyle after{.anchor = Anchor::start};
    sketch.arrow(middle, {top_right.x + Real(0.1), middle.y, -1});
    sketch.arrow(middle, {middle.x, top_right.y + Real(0.08), -1});
    sketch.label({top_right.x, middle.y, -1}, {28, 5}, "$x$", after);
    sketch.label({middle.x, top_right.y, -1}, {6, -9}, "$y$", after);
    sketch.label(top_right, {10, 5}, "$y$ = tan(FOV / 2)", after);
    sketch.label(bottom_right, {10, 5}, "$y$ = −tan(FOV / 2)", after);
}

/// One of the coordinates that MRT passes through, from the left edge to the right one.
struct Ruler {
    std::string_view name;
    Real left;
    Real right;
    int ends;      ///< decimals at its ends
    int decimals;  ///< and the other numbers
};

/// The ruler as a line so far below the grid, with the place of a pixel on it.
void draw_ruler(Sketch& sketch, Real below, const Ruler& ruler, Pixel chosen) {
    const Real height = corner_of({resolution.height, 0}).y - below;
    const auto on_ruler = [height](Vec3 p) { return Vec3(p.x, height, -1); };
    const Vec3 begin = on_ruler(corner_of({0, 0}));
    const Vec3 end = on_ruler(corner_of({0, resolution.width}));
    const Vec3 here = on_ruler(center_of(chosen));
    sketch.line(begin, end);
    for (int j = 0; j <= resolution.width; ++j) {
        const Vec3 tick = on_ruler(corner_of({0, j}));
        sketch.line(tick - Vec3(0, 0.015, 0), tick + Vec3(0, 0.015, 0));
    }
    const Real share = (here.x - begin.x) / (end.x - begin.x);
    const Real value = ruler.left + share * (ruler.right - ruler.left);
    sketch.mark(here, Mark::hit);
    sketch.label(begin, {-8, 5}, decimal(ruler.left, ruler.ends),
                 {.anchor = Anchor::end, .size = 13});
    sketch.label(end, {8, 5}, decimal(ruler.right, ruler.ends),
                 {.anchor = Anchor::start, .size = 13});
    sketch.label(here, {8, -6}, decimal(value, ruler.decimals),
                 {.color = red, .anchor = Anchor::start, .size = 13});
    sketch.label(end, {66, 5}, ruler.name, {.anchor = Anchor::start});
}

void draw_rulers(Sketch& sketch, Pixel chosen) {
    const Vec3 here = center_of(chosen);
    const Real edge = corner_of({0, resolution.width}).x;
    const Real bottom = corner_of({resolution.height, 0}).y;
    sketch.line(here, {here.x, bottom - Real(0.68), -1},
                {.color = red, .width = 1, .dashes = "3 4"});
    const Real columns = Real(resolution.width);
    draw_ruler(sketch, Real(0.17), {"$j$ + 0.5", 0, columns, 0, 1}, chosen);
    draw_ruler(sketch, Real(0.34), {"$pixNorm_x$", 0, 1, 0, 2}, chosen);
    draw_ruler(sketch, Real(0.51), {"$pixScreen_x$", -1, 1, 0, 1}, chosen);
    draw_ruler(sketch, Real(0.68), {"$pixFinal_x$", -edge, edge, 3, 3}, chosen);
}

}  // namespace

std::string pixel_grid() {
    Svg svg({640, 496}, "The pixels of a picture of 6 by 4 on the screen, and their coordinates");
    Sketch sketch(svg, {.place = {290, 196}, .scale = 215});
    constexpr Pixel chosen{.row = 1, .column = 4};
    const Vec3 here = center_of(chosen);
    const TextStyle style{.color = red, .anchor = Anchor::start, .size = 13};
    draw_cells(sketch, chosen);
    draw_counts(sketch);
    draw_axes(sketch);
    draw_rulers(sketch, chosen);
    const Vec3 beside(corner_of({0, resolution.width}).x, here.y, -1);
    sketch.label(beside, {10, -24}, "$i$ = 1, $j$ = 4:", style);
    sketch.label(beside, {10, -6}, "pixFinal =", style);
    sketch.label(beside, {10, 12}, "(" + decimal(here.x, 3) + ", " + decimal(here.y, 3) + ")",
                 style);
    return svg.source();
}

}  // namespace rt::figures
