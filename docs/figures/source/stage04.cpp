// Stage 4: how many steps of the ray fit between its origin and a plane.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/math/vector.hpp"
#include "steps/step04_plane/plane.hpp"

namespace rt::figures {

namespace {

/// The foot of the perpendicular from the point to the plane.
Vec3 foot_of(Vec3 point, const Plane& plane) {
    const Ray line{.origin = point, .direction = -normal(plane, point)};
    return at(line, all_roots(line, plane).front());
}

/// The plane, cut: a line with its inner side tinted.
void draw_cut(Sketch& sketch, Vec3 left, Vec3 right, Vec3 normal, Real depth) {
    sketch.polygon({left, right, right - depth * normal, left - depth * normal}, tint, no_pen);
    sketch.line(left, right, {.width = 2});
}

/// A plane that slopes up to the right, and a ray that sinks 0.8 of its distance, 2, a step.
const Plane slope{.point = {0, 0, 0}, .normal = unit(Vec3(-0.18, 1, 0))};
const Vec3 along(slope.normal.y, -slope.normal.x, 0);
const Ray sinking{.origin = Real(-4.4) * along + Real(2) * slope.normal,
                  .direction = Real(1.2) * along - Real(0.8) * slope.normal};
/// Through the ray's origin, across the slope: distances on it are measured along n.
const Plane upright{.point = sinking.origin, .normal = along};

void draw_steps(Sketch& sketch) {
    const Real t = intersect(sinking, slope, {}).value();
    const Vec3 foot = foot_of(sinking.origin, slope);
    draw_cut(sketch, Real(-4.75) * along, Real(0.35) * along, slope.normal, Real(0.22));
    sketch.arrow(sinking.origin, slope.point, {.color = gray, .width = 1.2});
    sketch.line(sinking.origin, foot, dashed);
    sketch.right_angle(foot, sinking.origin, slope.point);
    sketch.ray(sinking, t);
    for (int step = 1; step < t; ++step) {
        sketch.line(at(sinking, step), foot_of(at(sinking, step), upright), dashed);
        sketch.arrow(at(sinking, step - 1), at(sinking, step), {.color = blue, .width = 1.8});
    }
    sketch.measure(sinking.origin, foot, {-16, 3});
    sketch.measure(foot_of(at(sinking, 1), upright), foot_of(at(sinking, 2), upright), {14, -3});
    sketch.normal(slope.point, normal(slope, slope.point), 96);
    sketch.mark(sinking.origin, Mark::given);
    sketch.mark(slope.point, Mark::given);
    sketch.mark(foot, Mark::foot);
    sketch.mark(at(sinking, t), Mark::hit);
}

void label_steps(Sketch& sketch) {
    const Vec3 o_r = sinking.origin;
    const Vec3 n = normal(slope, slope.point);
    const Real t = intersect(sinking, slope, {}).value();
    const Vec3 half_way = (o_r + foot_of(o_r, slope)) / Real(2);
    const std::string distance = decimal(dot(slope.point - o_r, n), 1);
    const std::string approach = decimal(dot(sinking.direction, n), 1);
    const TextStyle before{.anchor = Anchor::end};
    const TextStyle of_ray{.color = blue};
    sketch.label(half_way, {-28, -4}, "⟨$o − o_r$, $n$⟩", before);
    sketch.label(half_way, {-28, 16}, "= " + distance, before);
    sketch.label(foot_of(at(sinking, Real(1.5)), upright), {24, 2}, "⟨$d_r$, $n$⟩ = " + approach,
                 {.anchor = Anchor::start});
    sketch.label(at(sinking, Real(0.5)), {-2, 20}, "$d_r$", of_ray);
    sketch.label(at(sinking, 1), {0, 22}, "$t$ = 1", of_ray);
    sketch.label(at(sinking, 2), {-16, 24}, "$t$ = 2", of_ray);
    sketch.label(at(sinking, t), {0, 26}, "$t$ = " + decimal(t, 1), {.color = red});
    sketch.label(o_r, {-4, -12}, "$o_r$");
    sketch.label(mix(o_r, slope.point, Real(0.6)), {8, -10}, "$o − o_r$", {.color = gray});
    sketch.label(slope.point, {4, 24}, "$o$");
    sketch.label(slope.point + n, {0, -10}, "$n$", {.color = green});
    sketch.label(slope.point, {-10, 106},
                 "$t$ = ⟨$o − o_r$, $n$⟩ / ⟨$d_r$, $n$⟩ = " + distance + " / " + approach + " = " +
                     decimal(t, 1) + " steps",
                 before);
}

}  // namespace

std::string plane_lengths() {
    Svg svg({640, 300}, "The t of a plane: a distance along n, counted in steps of the ray");
    Sketch sketch(svg, {.place = {584, 172}, .scale = 96});
    draw_steps(sketch);
    label_steps(sketch);
    return svg.source();
}

}  // namespace rt::figures
