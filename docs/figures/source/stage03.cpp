// Stage 3: half a chord of a sphere.
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

}  // namespace

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
