// Stage 8: the slope of a cone's normals, and the outline that MRT §8 prints.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step08_cone/cone.hpp"

#include <cmath>

namespace rt::figures {

namespace {

const Vec3 across(1, 0, 0);

/// The same slope without an end. A power of two changes no digit of the roots.
Cone endless(Cone cone) {
    cone.radius *= 16;
    cone.height *= 16;
    return cone;
}

/// The point of the side at a height z, in a direction across the axis.
Vec3 side_point(const Cone& cone, Real z, Vec3 direction) {
    const Ray ray{.origin = cone.apex + z * cone.axis, .direction = direction};
    return first_hit(ray, endless(cone));
}

void draw_sides(Sketch& sketch, const Cone& cone, Real z, const Pen& pen) {
    sketch.line(cone.apex, side_point(cone, z, -across), pen);
    sketch.line(cone.apex, side_point(cone, z, across), pen);
}

void draw_cone(Sketch& sketch, const Cone& cone) {
    const Vec3 left = side_point(cone, cone.height, -across);
    const Vec3 right = side_point(cone, cone.height, across);
    sketch.polygon({cone.apex, left, right}, tint, no_pen);
    sketch.line(left, right, {.color = gray, .width = 1});
    draw_sides(sketch, cone, cone.height, {.width = 2});
}

constexpr Cone cup{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 1.7};

}  // namespace

std::string cone_slope() {
    Svg svg({640, 330}, "The normal of a cone is as steep as its side, with r and h exchanged");
    Sketch sketch(svg, {.place = {196, 296}, .scale = 140});
    const Vec3 top = cup.apex + cup.height * cup.axis;
    const Vec3 rim = side_point(cup, cup.height, across);
    const Vec3 p = side_point(cup, Real(1.2), across);
    const Vec3 end = p + distance(cup.apex, rim) * normal(cup, p);  // h across, r down
    const Vec3 corner(end.x, p.y, 0);
    draw_cone(sketch, cup);
    sketch.arrow(cup.apex, cup.apex + Real(1.95) * cup.axis, {.color = green, .width = 1.5});
    sketch.measure(top, rim, {0, -12});
    sketch.measure(cup.apex, top, {-14, 0});
    sketch.arrow(p, corner, {.color = gray, .width = 1.5, .dashes = "4 4"});
    sketch.arrow(corner, end, {.color = gray, .width = 1.5, .dashes = "4 4"});
    sketch.right_angle(p, cup.apex, end);
    sketch.arrow(p, end, {.color = green, .width = 2.2});
    sketch.mark(cup.apex, Mark::given);
    sketch.mark(p, Mark::hit);

    const TextStyle note{.color = gray, .anchor = Anchor::start, .size = 13};
    sketch.label(cup.apex, {-14, 6}, "$o$");
    sketch.label(cup.apex + Real(1.95) * cup.axis, {14, 8}, "$Z$", {.color = green});
    sketch.label((top + rim) / Real(2), {6, -18}, "$r$");
    sketch.label(top / Real(2), {-22, -20}, "$h$", {.anchor = Anchor::end});
    sketch.label(p, {-16, 6}, "$p$", {.color = red});
    sketch.label((p + corner) / Real(2), {0, -9}, "$h$, away from the axis", {.color = gray});
    sketch.label((corner + end) / Real(2), {9, 5}, "$r$, towards", note);
    sketch.label((corner + end) / Real(2), {9, 22}, "the apex", note);
    sketch.label((p + end) / Real(2), {-6, 24}, "$n$", {.color = green});
    return svg.source();
}

namespace {

/// The cone of MRT §8 as printed, x² + y² = (r/h) z²: a radius of √(r h) at z = h.
Cone printed(Cone cone) {
    cone.radius = std::sqrt(cone.radius * cone.height);
    return cone;
}

void draw_outlines(Svg& svg, Vec2 place, Real height, int decimals, std::string_view caption) {
    Sketch sketch(svg, {.place = place, .scale = 76});
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = height};
    const Vec3 top = cone.apex + height * cone.axis;
    const Vec3 rim = side_point(cone, height, across);
    const Vec3 printed_rim = side_point(printed(cone), height, across);
    draw_cone(sketch, cone);
    sketch.line(cone.apex, {0, height, 0}, dashed);
    draw_sides(sketch, printed(cone), height, {.color = purple, .width = 2.2, .dashes = "6 5"});
    sketch.measure(top, rim, {0, -14}, {.width = 1});
    sketch.measure(top, printed_rim, {0, -38}, {.color = purple, .width = 1});
    sketch.label(rim / Real(2) + top / Real(2), {0, -19}, decimal(distance(top, rim), 0),
                 {.size = 13});
    sketch.label(printed_rim / Real(2) + top / Real(2), {0, -43},
                 decimal(distance(top, printed_rim), decimals), {.color = purple, .size = 13});
    svg.text(place + Vec2(0, 26), caption);
}

}  // namespace

std::string cone_coefficient() {
    Svg svg({640, 320}, "Cones with r = 1 as they should be, and as MRT §8 prints them");
    const TextStyle after{.anchor = Anchor::start};
    draw_outlines(svg, {124, 276}, 2, 3, "$r$ = 1, $h$ = 2");
    draw_outlines(svg, {344, 276}, 1, 0, "$r$ = 1, $h$ = 1");
    draw_outlines(svg, {540, 276}, Real(0.5), 3, "$r$ = 1, $h$ = 0.5");
    svg.line({300, 66}, {334, 66}, {.width = 2});
    svg.text({344, 71}, "$x_p$² + $y_p$² = ($r$ / $h$)² $z_p$²", after);
    svg.line({300, 94}, {334, 94}, {.color = purple, .width = 2.2, .dashes = "6 5"});
    svg.text({344, 99}, "$x_p$² + $y_p$² = ($r$ / $h$) $z_p$², as printed",
             {.color = purple, .anchor = Anchor::start});
    return svg.source();
}

}  // namespace rt::figures
