// Stage 4: how many steps of the ray fit between its origin and a plane, and the horizon.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "common/vector.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step04_plane/plane.hpp"

namespace rt::figures {

namespace {

/// Where the perpendicular from the point meets the plane.
Vec3 foot_of(Vec3 point, const Plane& plane) {
    const Ray down{.origin = point, .direction = -normal(plane, point)};
    return at(down, all_roots(down, plane).front());
}

/// The plane, cut: a line with its inner side tinted.
void draw_cut(Sketch& sketch, Vec3 left, Vec3 right, Vec3 normal, Real depth) {
    sketch.polygon({left, right, right - depth * normal, left - depth * normal}, tint, no_pen);
    sketch.line(left, right, {.width = 2});
}

}  // namespace

std::string plane_steps() {
    Svg svg({640, 390}, "The t of a plane as a number of steps");
    Sketch sketch(svg, {.place = {580, 255}, .scale = 96});
    const Plane plane{.point = {0, 0, 0}, .normal = unit(Vec3(-0.18, 1, 0))};
    const Vec3 n = normal(plane, plane.point);
    const Vec3 along(n.y, -n.x, 0);
    const Ray ray{.origin = Real(-4.4) * along + Real(2) * n,
                  .direction = Real(1.2) * along - Real(0.8) * n};
    const Real t = intersect(ray, plane, {}).value();
    const Vec3 foot = foot_of(ray.origin, plane);

    draw_cut(sketch, Real(-4.75) * along, Real(0.35) * along, n, Real(0.22));
    sketch.arrow(ray.origin, plane.point, {.color = gray, .width = 1.2});
    sketch.line(ray.origin, foot, dashed);
    for (int step = 1; step < t; ++step) {
        const Vec3 p = at(ray, step);
        sketch.line(p, foot_of(p, {.point = ray.origin, .normal = along}), dashed);
    }
    sketch.ray(ray, t);
    for (int step = 1; step < t; ++step)
        sketch.arrow(at(ray, step - 1), at(ray, step), {.color = blue, .width = 1.8});
    sketch.normal(plane.point, n, 96);
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(plane.point, Mark::given);
    sketch.mark(foot, Mark::foot);
    sketch.mark(at(ray, t), Mark::hit);
    return svg.source();
}

std::string plane_horizon() {
    Svg svg({640, 340}, "Rays of one column of pixels above a ground: hits, the horizon, the sky");
    constexpr Resolution resolution{.width = 1, .height = 7};
    constexpr Real fov = pi * 80 / 180;
    Sketch sketch(svg, {.place = {190, 190}, .scale = 92, .right = {0, 0, -1}});
    const Plane ground{.point = {0, -1, 0}, .normal = {0, 1, 0}};

    draw_cut(sketch, {0, -1, 1.85}, {0, -1, -4.7}, ground.normal, Real(0.2));
    for (int i = 0; i < resolution.height; ++i) {
        const Ray ray = camera_ray({i, 0}, resolution, fov);
        const std::optional<Real> hit = intersect(ray, ground, {});
        sketch.ray(ray, hit ? *hit : 2);
        sketch.mark(at(ray, 1), Mark::foot);
        if (hit) sketch.mark(at(ray, *hit), Mark::hit);
    }
    return svg.source();
}

}  // namespace rt::figures
