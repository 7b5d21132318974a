// Stage 3: where a line hits a sphere.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt::figures {

namespace {

constexpr Sphere sphere{.center = {0, 0, 0}, .radius = 1};

void draw_sphere(Svg& svg, const Sketch& sketch) {
    const Vec2 center = sketch(sphere.center);
    svg.circle(center, distance(center, sketch(sphere.center + Vec3(sphere.radius, 0, 0))), tint);
}

/// One case of a ray and the sphere: the hit, the rejected roots, and the meaning.
void draw_case(Sketch& sketch, Vec3 origin, std::string_view meaning) {
    constexpr Real left = -1.75;
    constexpr Real right = 2;
    const Ray ray{.origin = origin, .direction = {1, 0, 0}};
    const std::vector<Real> roots = all_roots(ray, sphere);
    if (origin.x > left) sketch.backwards(ray, left - origin.x);
    sketch.ray(ray, right - origin.x);
    sketch.mark(origin, Mark::given);

    const std::optional<Real> hit = intersect(ray, sphere, {});
    for (const Real t : roots) {
        const Vec3 p = at(ray, t);
        const bool first = t == roots.front();
        if (t == hit) sketch.normal(p, normal(sphere, p), 34);
        sketch.mark(p, t == hit ? Mark::hit : Mark::refused);
        if (roots.size() == 2)
            sketch.label(p, {first ? 9 : -9, -8}, first ? "$t_1$" : "$t_2$",
                         {.color = red, .anchor = first ? Anchor::start : Anchor::end});
    }
    sketch.label({left, origin.y, 0}, {-14, 5}, meaning, {.anchor = Anchor::end});
}

void draw_key(Svg& svg, Vec2 place) {
    Sketch key(svg, {.place = place, .scale = 1});
    const TextStyle style{.anchor = Anchor::start, .size = 13};
    key.mark({0, 0, 0}, Mark::hit);
    key.label({0, 0, 0}, {12, 5}, "hit: the smallest $t$ > 0", style);
    key.mark({200, 0, 0}, Mark::refused);
    key.label({200, 0, 0}, {12, 5}, "a root, refused", style);
    key.backwards({.origin = {375, 0, 0}, .direction = {1, 0, 0}}, -34);
    key.label({375, 0, 0}, {8, 5}, "$t$ < 0", style);
    key.normal({460, 0, 0}, {1, 0, 0}, 34);
    key.label({494, 0, 0}, {8, 5}, "$n$", style);
}

}  // namespace

std::string sphere_roots() {
    Svg svg({640, 348},
            "Five rays and a sphere: a miss, a tangent, from outside, from inside, behind");
    Sketch sketch(svg, {.place = {415, 172}, .scale = 106});
    draw_sphere(svg, sketch);
    draw_case(sketch, {-1.75, 1.3, 0}, "Δ < 0: passes by");
    draw_case(sketch, {-1.75, 1, 0}, "Δ = 0: touches");
    draw_case(sketch, {-1.75, 0.5, 0}, "0 < $t_1$ < $t_2$: from outside");
    draw_case(sketch, {-0.25, -0.05, 0}, "$t_1$ < 0 < $t_2$: from inside");
    draw_case(sketch, {1.35, -0.6, 0}, "$t_1$ < $t_2$ < 0: behind");
    draw_key(svg, {56, 320});
    return svg.source();
}

std::string sphere_half_chord() {
    Svg svg({640, 374}, "Half a chord on either side of the point of the line nearest the center");
    Sketch sketch(svg, {.place = {405, 190}, .scale = 145});
    const Ray ray{.origin = {-2.6, -0.35, 0}, .direction = {0.9, 0.22, 0}};
    const std::vector<Real> roots = all_roots(ray, sphere);
    const Vec3 near = at(ray, roots.front());
    const Vec3 far = at(ray, roots.back());
    const Vec3 closest = at(ray, (roots.front() + roots.back()) / 2);

    draw_sphere(svg, sketch);
    sketch.ray(ray, Real(4.3));
    sketch.line(sphere.center, near, thin);
    sketch.line(sphere.center, far, thin);
    sketch.right_angle(closest, sphere.center, near);
    sketch.arrow(sphere.center, closest, {.width = 1.8});
    sketch.arrow(ray.origin, at(ray, 1), {.color = blue, .width = 3});
    sketch.measure(near, closest, {-6, -25});
    sketch.measure(closest, far, {-6, -25});
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(sphere.center, Mark::given);
    sketch.mark(closest, Mark::foot);
    sketch.mark(near, Mark::hit);
    sketch.mark(far, Mark::refused);

    sketch.label((near + closest) / Real(2), {-12, -37}, "√($r$² − ‖$q$‖²)", {.size = 13});
    sketch.label((closest + far) / Real(2), {-12, -37}, "√($r$² − ‖$q$‖²)", {.size = 13});
    sketch.label(ray.origin, {-2, -12}, "$o_r$");
    sketch.label(at(ray, Real(0.5)), {0, -12}, "$d_r$", {.color = blue});
    sketch.label(near, {-9, 20}, "$t_1$", {.color = red, .anchor = Anchor::end});
    sketch.label(far, {11, 18}, "$t_2$", {.color = red, .anchor = Anchor::start});
    sketch.label(closest, {13, 16}, "$t_0$", {.color = gray, .anchor = Anchor::start});
    sketch.label(closest / Real(2), {-8, 4}, "$q$", {.anchor = Anchor::end});
    sketch.label(near / Real(2), {-4, 20}, "$r$");
    sketch.label(far / Real(2), {11, 12}, "$r$");
    sketch.label(sphere.center, {6, 18}, "$o$");
    sketch.label(ray.origin, {-16, 100}, "$t$ = $t_0$ ± √($r$² − ‖$q$‖²) / ‖$d_r$‖",
                 {.anchor = Anchor::start, .size = 15});
    return svg.source();
}

}  // namespace rt::figures
