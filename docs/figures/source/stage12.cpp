// Stage 12: the reflected direction, and a normal that would send a ray in.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/math/vector.hpp"

#include "steps/step12_mirror/mirror.hpp"

#include <cmath>

namespace rt::figures {

namespace {

/// The mirror y = 0, hit by the ray at t = 1.
ShadingPoint ground(const Ray& ray, Vec3 normal, Real error = 0) {
    return {.point = at(ray, 1), .normal = normal, .geometric_normal = {0, 1, 0}, .error = error};
}

/// The mirror's face from one place to another, its back shaded.
void draw_face(Sketch& sketch, Vec3 from, Vec3 to, Vec3 back) {
    sketch.polygon({from, to, to + back, from + back}, tint, no_pen);
    sketch.line(from, to, {.width = 2});
}

}  // namespace

std::string mirror_direction() {
    Svg svg({640, 390}, "The part of d along the normal, taken away twice, leaves R");
    Sketch sketch(svg, {.place = {300, 196}, .scale = 112});
    const Ray ray{.origin = {Real(-1.9), Real(1.4), 0}, .direction = {Real(1.9), Real(-1.4), 0}};
    const ShadingPoint surface = ground(ray, {0, 1, 0});
    const Vec3 p = surface.point;
    const Vec3 on = p + ray.direction;  // the end of d, drawn from p
    const Vec3 reflected = p + mirrored(ray, surface).direction;
    const Vec3 half = (on + reflected) / Real(2);
    const TextStyle of_part{.anchor = Anchor::start, .size = 13};
    draw_face(sketch, {Real(-2.4), 0, 0}, {Real(2.4), 0, 0}, {0, Real(-0.1), 0});
    sketch.arrow(ray.origin, p, {.color = blue, .width = 2});
    sketch.arrow(p, on, {.color = blue, .width = 1.4, .dashes = "5 4"});
    sketch.arrow(p, reflected, {.color = blue, .width = 2});
    sketch.arrow(on, half, {.width = 1.5});
    sketch.arrow(half, reflected, {.width = 1.5});
    sketch.angle(p, ray.origin, p + surface.normal, 52);
    sketch.angle(p, p + surface.normal, reflected, 52);
    sketch.normal(p, surface.normal, 112);
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(p, Mark::hit);
    sketch.label((ray.origin + p) / Real(2), {-12, 14}, "$d$", {.color = blue});
    sketch.label((on + p) / Real(2), {-12, 14}, "$d$", {.color = blue});
    sketch.label((reflected + p) / Real(2), {-10, -10}, "$R$", {.color = blue});
    sketch.label((on + half) / Real(2), {10, 5}, "−⟨$d$, $n$⟩ $n$", of_part);
    sketch.label((half + reflected) / Real(2), {10, 5}, "−⟨$d$, $n$⟩ $n$", of_part);
    sketch.label(p + surface.normal, {12, 2}, "$n$", {.color = green, .anchor = Anchor::start});
    sketch.label(p, {-18, -60}, "θ");
    sketch.label(p, {18, -60}, "θ");
    sketch.label(p, {-10, 32}, "$p$", {.color = red});
    svg.text({200, 330}, "$R$ = $d$ − 2 $n$ ⟨$d$, $n$⟩", {.size = 15});
    return svg.source();
}

std::string mirror_interpolated() {
    Svg svg({640, 284},
            "An interpolated normal sends a flat ray into the face: reflect at the face");
    Sketch sketch(svg, {.place = {330, 190}, .scale = 150});
    const auto leaning = [](Real degrees) {
        const Real angle = degrees * pi / 180;
        return Vec3(std::sin(angle), std::cos(angle), 0);
    };
    const Vec3 eye = Real(1.65) * leaning(-74);
    const Ray ray{.origin = eye, .direction = -eye};
    const ShadingPoint smooth = ground(ray, leaning(14));
    const ShadingPoint flat = ground(ray, smooth.geometric_normal);
    const Vec3 n = smooth.normal;
    const Vec3 into = ray.direction - 2 * dot(ray.direction, n) * n;  // CR's equation 4, no more
    const Vec3 out = mirrored(ray, smooth).direction;
    draw_face(sketch, {Real(-1.9), 0, 0}, {Real(1.8), 0, 0}, {0, Real(-0.09), 0});
    sketch.arrow(ray.origin, smooth.point, {.color = blue, .width = 2});
    sketch.arrow(smooth.point, into / Real(1.1), {.color = purple, .width = 1.6, .dashes = "5 4"});
    sketch.arrow(smooth.point, out / Real(1.1), {.color = blue, .width = 2});
    sketch.normal(smooth.point, flat.geometric_normal, 105);
    sketch.normal(smooth.point, n, 105);
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(smooth.point, Mark::hit);
    sketch.label(ray.origin / Real(2), {0, -12}, "$d$", {.color = blue});
    sketch.label(smooth.point, {-6, -114}, "side", {.color = green, .anchor = Anchor::end});
    sketch.label(smooth.point, {36, -108}, "$n$, interpolated",
                 {.color = green, .anchor = Anchor::start});
    sketch.label(out / Real(1.1), {-20, -14}, "at the face: out",
                 {.color = blue, .anchor = Anchor::end});
    sketch.label(into / Real(1.1), {-20, 26}, "at $n$: into the face",
                 {.color = purple, .anchor = Anchor::end});
    return svg.source();
}

}  // namespace rt::figures
