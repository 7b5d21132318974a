// Stage 3: where a line meets a sphere.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step03_sphere/sphere.hpp"

#include <cmath>

namespace rt::figures {

namespace {

void draw_sphere(Svg& svg, const Sketch& sketch, const Sphere& sphere) {
    const Vec2 center = sketch(sphere.center);
    const Vec2 rim = sketch(sphere.center + Vec3(sphere.radius, 0, 0));
    svg.circle(center, distance(center, rim), tint);
}

/// One way for a ray to meet the sphere: what is met, what is refused, and what that means.
void draw_case(Sketch& sketch, const Sphere& sphere, Vec3 origin, std::string_view meaning) {
    const Ray ray{.origin = origin, .direction = {1, 0, 0}};
    constexpr Real left = -1.75;
    constexpr Real right = 2;
    const std::vector<Real> roots = all_roots(ray, sphere);
    if (origin.x > left) sketch.backwards(ray, left - origin.x);
    sketch.ray(ray, right - origin.x);
    sketch.mark(origin, Mark::given);

    const std::optional<Real> hit = intersect(ray, sphere, {});
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const Vec3 p = at(ray, roots[i]);
        const bool met = roots[i] == hit;
        if (met) sketch.normal(p, normal(sphere, p), 34);
        sketch.mark(p, met ? Mark::hit : Mark::refused);
        const bool left_side = p.x < sphere.center.x;
        if (roots.size() == 2)
            sketch.label(p, {left_side ? 9 : -9, -8}, i == 0 ? "$t_1$" : "$t_2$",
                         {.color = red, .anchor = left_side ? Anchor::start : Anchor::end});
    }
    sketch.label({left, origin.y, 0}, {-14, 5}, meaning, {.anchor = Anchor::end});
}

}  // namespace

std::string sphere_roots() {
    Svg svg({640, 350},
            "Five rays and a sphere: a miss, a tangent, from outside, from inside, behind");
    Sketch sketch(svg, {.place = {415, 178}, .scale = 106});
    const Sphere sphere{.center = {0, 0, 0}, .radius = 1};
    draw_sphere(svg, sketch, sphere);
    draw_case(sketch, sphere, {-1.75, 1.3, 0}, "Δ < 0: passes by");
    draw_case(sketch, sphere, {-1.75, 1, 0}, "Δ = 0: touches");
    draw_case(sketch, sphere, {-1.75, 0.5, 0}, "0 < $t_1$ < $t_2$: from outside");
    draw_case(sketch, sphere, {-0.25, -0.05, 0}, "$t_1$ < 0 < $t_2$: from inside");
    draw_case(sketch, sphere, {1.35, -0.6, 0}, "$t_1$ < $t_2$ < 0: behind");
    return svg.source();
}

std::string sphere_half_chord() {
    Svg svg({640, 360},
            "Half a chord on either side of the point of the line nearest to the centre");
    Sketch sketch(svg, {.place = {405, 205}, .scale = 135});
    const Sphere sphere{.center = {0, 0, 0}, .radius = 1};
    const Ray ray{.origin = {-2.6, -0.1, 0}, .direction = {0.9, 0.22, 0}};
    const std::vector<Real> roots = all_roots(ray, sphere);
    const Vec3 near = at(ray, roots.front());
    const Vec3 far = at(ray, roots.back());
    const Vec3 closest = at(ray, (roots.front() + roots.back()) / 2);

    draw_sphere(svg, sketch, sphere);
    sketch.ray(ray, Real(5));
    sketch.line(sphere.center, near, thin);
    sketch.line(sphere.center, far, thin);
    sketch.line(sphere.center, closest, {.width = 1.5});
    sketch.right_angle(closest, sphere.center, near);
    sketch.arrow(ray.origin, at(ray, 1), {.color = blue, .width = 3});
    sketch.measure(near, closest, {5, -22});
    sketch.measure(closest, far, {5, -22});
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(sphere.center, Mark::given);
    sketch.mark(closest, Mark::foot);
    sketch.mark(near, Mark::hit);
    sketch.mark(far, Mark::refused);
    return svg.source();
}

}  // namespace rt::figures
