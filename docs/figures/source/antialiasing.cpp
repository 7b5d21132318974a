#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/svg.hpp"

#include "common/geometry/ray.hpp"
#include "common/render/sampling.hpp"

#include "steps/step05_triangle/triangle.hpp"

#include <string>
#include <vector>

namespace rt::figures {

namespace {

constexpr int side = 4;
constexpr int count = side * side;
constexpr Real square = 180;  // pixels

/// The region beyond the edge: a triangle that covers the left of the pixel (0, 1)².
constexpr Triangle covering{.a = {0.55, 3, 0}, .b = {-9, 0.5, 0}, .c = {0.45, -2, 0}};

bool is_covered(Vec2 point) {
    const Ray ray{.origin = {point.x, point.y, 1}, .direction = {0, 0, -1}};
    return intersect(ray, covering, {}).has_value();
}

/// The x of the edge at this height.
Real edge(Real y) {
    const Real share = (covering.a.y - y) / (covering.a.y - covering.c.y);
    return covering.a.x + share * (covering.c.x - covering.a.x);
}

/// Each point is the first one of a sequence of its own.
Vec2 independent(std::uint32_t i) {
    return spread_sample(0, sample_seed({.row = int(i), .column = 4}, 1, 0));
}

Vec2 regular(std::uint32_t i) {
    return (Vec2(i % side, i / side) + Real(0.5)) / Real(side);
}

Vec2 spread(std::uint32_t i) {
    return spread_sample(i, 4);
}

void draw_pixel(Svg& svg, Vec2 corner, const std::string& name, Vec2 (*point)(std::uint32_t)) {
    const auto place = [&](Vec2 p) { return corner + square * Vec2(p.x, 1 - p.y); };
    svg.polygon({place({0, 0}), place({edge(0), 0}), place({edge(1), 1}), place({0, 1})}, pale_blue,
                no_pen);
    for (int i = 0; i <= side; ++i) {
        const Real share = Real(i) / side;
        const Pen pen{.color = i % side == 0 ? ink : faint, .width = 1};
        svg.line(place({share, 0}), place({share, 1}), pen);
        svg.line(place({0, share}), place({1, share}), pen);
    }
    svg.line(place({edge(0), 0}), place({edge(1), 1}), {.width = 2});
    int covered = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool is_inside = is_covered(point(i));
        covered += is_inside ? 1 : 0;
        svg.circle(place(point(i)), 4, is_inside ? blue : white, {.color = blue});
    }
    const Real middle = corner.x + square / 2;
    svg.text({middle, corner.y - 12}, name);
    svg.text({middle, corner.y + square + 24},
             std::to_string(covered) + " of " + std::to_string(count));
}

}  // namespace

std::string pixel_points() {
    Svg svg({640, 250}, "an edge through a pixel, and 16 rays: regular, independent and spread");
    draw_pixel(svg, {22, 32}, "regular", regular);
    draw_pixel(svg, {230, 32}, "independent", independent);
    draw_pixel(svg, {438, 32}, "spread", spread);
    return svg.source();
}

}  // namespace rt::figures
