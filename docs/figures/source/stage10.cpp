// Stage 10: the part of a shadow ray in which an occluder counts, and the start of the ray.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step10_shadows/shadows.hpp"

namespace rt::figures {

namespace {

constexpr Vec3 up(0, 1, 0);

ShadingPoint surface_of(Vec3 point, Vec3 side, Real error) {
    return {.point = point,
            .normal = side,
            .geometric_normal = side,
            .to_eye = side,
            .error = error,
            .material = {}};
}

void draw_ball(Svg& svg, const Sketch& sketch, const Sphere& ball) {
    const Vec2 center = sketch(ball.center);
    svg.circle(center, distance(center, sketch(ball.center + Vec3(ball.radius, 0, 0))), tint);
}

/// The ray from a point of the floor, and the result for each sphere on its line.
void draw_way(Sketch& sketch, Vec3 point, Vec3 light, const Sphere& ball, Real beyond) {
    const auto [ray, interval] = shadow_ray(surface_of(point, up, 0), light);
    const bool blocked = intersect(ray, ball, interval).has_value();
    const Vec3 near = first_hit(ray, ball);
    if (blocked) {
        sketch.arrow(ray.origin, near, {.color = blue, .width = 1.8});
        sketch.line(near, light, dashed);
    } else {
        sketch.arrow(ray.origin, light, {.color = blue, .width = 1.8});
        sketch.line(light, at(ray, beyond), dashed);
    }
    sketch.mark(near, blocked ? Mark::hit : Mark::refused);
    sketch.mark(point, Mark::given);
}

}  // namespace

std::string shadow_range() {
    Svg svg({640, 372},
            "A ball before the light throws a shadow, and one behind the light does not");
    Sketch sketch(svg, {.place = {300, 318}, .scale = 96});
    const Vec3 light(0.5, 2, 0);
    const Vec3 in_shadow(-2.2, 0, 0);
    const Vec3 lit(2.2, 0, 0);
    const Sphere before{.center = {-0.95, 1.02, 0}, .radius = 0.42};
    const Sphere behind{.center = {-0.28, 2.86, 0}, .radius = 0.3};
    sketch.polygon({{-3, 0, 0}, {3.4, 0, 0}, {3.4, -0.16, 0}, {-3, -0.16, 0}}, tint, no_pen);
    sketch.line({-3, 0, 0}, {3.4, 0, 0}, {.width = 2});
    draw_ball(svg, sketch, before);
    draw_ball(svg, sketch, behind);
    draw_way(sketch, in_shadow, light, before, 1);
    draw_way(sketch, lit, light, behind, Real(1.62));
    svg.circle(sketch(light), 7, "#ffd75e", {.color = amber});
    const TextStyle after{.anchor = Anchor::start, .size = 13};
    sketch.label(light, {16, 0}, "the light, $t$ = 1", after);
    sketch.label(before.center, {46, 6}, "0 < $t$ < 1: in the way", after);
    sketch.label(behind.center, {38, 4}, "$t$ > 1: behind the light", after);
    sketch.label(in_shadow, {20, 34}, "in shadow: ambient light only", {.size = 13});
    sketch.label(lit, {0, 34}, "lit", {.size = 13});
    sketch.label(lit, {12, -8}, "$t$ = 0", after);
    return svg.source();
}

namespace {

/// Much of a ball, so close that its surface is almost flat.
constexpr Sphere ground{.center = {0, -4, 0}, .radius = 4};
/// An object on it, as close as an error.
constexpr Sphere crumb{.center = {0.72, 0.24, 0}, .radius = 0.17};
constexpr Vec3 light_of_ground(4, 0.75, 0);

Sketch draw_ground(Svg& svg, Vec2 place, bool with_crumb) {
    Sketch sketch(svg, {.place = place, .scale = 88});
    std::vector<Vec3> outline;
    for (int i = -20; i <= 20; ++i) {
        const Ray down{.origin = {Real(i) * Real(0.055), 3, 0}, .direction = {0, -1, 0}};
        outline.push_back(first_hit(down, ground));
    }
    std::vector<Vec3> filled = outline;
    filled.insert(filled.end(), {{1.1, -0.75, 0}, {-1.1, -0.75, 0}});
    sketch.polygon(filled, tint, no_pen);
    for (std::size_t i = 1; i < outline.size(); ++i)
        sketch.line(outline[i - 1], outline[i], {.width = 2});
    if (with_crumb) draw_ball(svg, sketch, crumb);
    return sketch;
}

void draw_start(Sketch& sketch, Vec3 origin, const Sphere& any_hit) {
    const Ray ray{.origin = origin, .direction = normalize(light_of_ground - origin)};
    const std::optional<Real> t = intersect(ray, any_hit, {});
    sketch.ray(ray, Real(1.25));
    if (t) sketch.mark(at(ray, *t), Mark::hit);
    sketch.mark(origin, Mark::given);
}

}  // namespace

std::string shadow_start() {
    Svg svg({660, 262},
            "Three starts of a shadow ray: on the surface, too far from it, by its error");
    const Vec3 point(-0.45, -0.025, 0);
    const Vec3 side = normal(ground, point);
    constexpr Real error = 0.16;
    const Vec3 rounded = point - error * side;
    const TextStyle words;

    Sketch on = draw_ground(svg, {112, 130}, false);
    draw_start(on, rounded, ground);
    on.label(rounded, {-2, 24}, "$o$ + $t d$, rounded", words);
    svg.text({112, 226}, "on the surface:", words);
    svg.text({112, 244}, "it hits itself, acne", words);

    Sketch far = draw_ground(svg, {330, 130}, true);
    far.normal(point, side, 60);
    draw_start(far, point + Real(60) / 88 * side, crumb);
    far.label(point + Real(0.4) * side, {-8, 4}, "ε", {.color = green, .anchor = Anchor::end});
    svg.text({330, 226}, "a constant too large:", words);
    svg.text({330, 244}, "it skips what is close", words);

    Sketch ours = draw_ground(svg, {548, 130}, true);
    const Vec3 start = shadow_ray(surface_of(point, side, error), light_of_ground).ray.origin;
    svg.circle(ours(point), error * 88, none, dashed);
    ours.normal(point, side, error * 88);
    draw_start(ours, start, crumb);
    ours.label(point, {-18, -2}, "error", {.color = green, .anchor = Anchor::end, .size = 13});
    svg.text({548, 226}, "re-projected, off by its error:", words);
    svg.text({548, 244}, "no acne, nothing missed", words);
    return svg.source();
}

}  // namespace rt::figures
