// Stage 11: umbra and penumbra, and a penumbra off center.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/render/sampling.hpp"
#include "common/scene/scene.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <cmath>

namespace rt::figures {

namespace {

constexpr Light lamp{.position = {Real(-2.3), Real(4.6), 0}, .radius = Real(0.75)};

/// Flat, one wide, seen edge-on: its y runs across the page, its x along the page's depth.
const Square plate{.center = {Real(-0.9), Real(2.3), 0},
                   .basis = {.x = {0, 0, 1}, .y = {1, 0, 0}, .z = {0, 1, 0}},
                   .side = Real(1.7)};

/// The intersection with the ground of a line through the plate's edge that touches the lamp.
Vec3 shadow_end(Vec3 edge, Real side) {
    const Vec3 way = lamp.position - edge;
    const Real half_angle = std::asin(lamp.radius / length(way));
    const Real angle = std::atan2(way.y, way.x) + side * half_angle;
    return {edge.x - edge.y * std::cos(angle) / std::sin(angle), 0, 0};
}

/// The point of the lamp where that line touches it.
Vec3 touched(Vec3 edge, Real side) {
    const Vec3 way = lamp.position - edge;
    const Real tangent = std::sqrt(dot(way, way) - lamp.radius * lamp.radius);
    const Real angle = std::atan2(way.y, way.x) + side * std::asin(lamp.radius / length(way));
    return edge + tangent * Vec3(std::cos(angle), std::sin(angle), 0);
}

void draw_shadow(Svg& svg, Sketch& sketch, Vec3 left, Vec3 right) {
    const Vec3 outer_left = shadow_end(left, -1);
    const Vec3 umbra_left = shadow_end(left, 1);
    const Vec3 umbra_right = shadow_end(right, -1);
    const Vec3 outer_right = shadow_end(right, 1);
    sketch.polygon({left, right, outer_right, outer_left}, tint, no_pen);
    sketch.polygon({left, right, umbra_right, umbra_left}, faint, no_pen);
    for (const Real side : {Real(-1), Real(1)}) {
        sketch.line(touched(left, side), shadow_end(left, side), dashed);
        sketch.line(touched(right, side), shadow_end(right, side), dashed);
    }
    sketch.line({-4, 0, 0}, {5, 0, 0}, {.width = 2});
    const auto name = [&](Vec3 from, Vec3 to, std::string_view what) {
        sketch.measure(from, to, {0, 14});
        const Vec2 place = (sketch(from) + sketch(to)) / Real(2);
        svg.text(place + Vec2(0, 34), what);
    };
    name(outer_left, umbra_left, "penumbra");
    name(umbra_left, umbra_right, "umbra");
    name(umbra_right, outer_right, "penumbra");
}

}  // namespace

std::string soft_shadow_regions() {
    Svg svg({640, 378}, "A lamp with a size, a plate, its umbra and its penumbra, and nine rays");
    Sketch sketch(svg, {.place = {292, 322}, .scale = 58});
    const Vec3 half = plate.side / 2 * plate.basis.y;
    const Vec3 left = plate.center - half;
    const Vec3 right = plate.center + half;
    draw_shadow(svg, sketch, left, right);
    svg.circle(sketch(lamp.position), 58 * lamp.radius, white, {.width = 2});

    // Uniform over the angle that the light fills, in the plane of the page.
    const Vec3 from(Real(2.1), 0, 0);
    const Vec3 way = lamp.position - from;
    const Real middle = std::atan2(way.y, way.x);
    const Real half_angle = std::asin(lamp.radius / length(way));
    constexpr int all = 9;
    ShadowRays rays;
    for (; rays.sent < all; ++rays.sent) {
        const Real angle = middle + half_angle * (Real(2 * int(rays.sent) + 1) / all - 1);
        const Vec3 aim =
            first_hit(Ray{.origin = from, .direction = {std::cos(angle), std::sin(angle), 0}},
                      Sphere{.center = lamp.position, .radius = lamp.radius});
        const Ray ray{.origin = from, .direction = aim - from};
        const std::optional<Real> hit = intersect(ray, plate, {.max = 1});
        if (hit) {
            sketch.line(from, at(ray, *hit), {.color = gray, .width = 1});
            sketch.mark(at(ray, *hit), Mark::refused);
        } else {
            sketch.line(from, aim, {.color = blue, .width = 1.3});
            sketch.mark(aim, Mark::hit);
            ++rays.reached;
        }
    }
    sketch.line(left, right, {.width = 5});
    sketch.mark(from, Mark::given);
    sketch.label(from, {18, -8}, "$p$");
    sketch.label(lamp.position, {-76, 5}, "the light");
    svg.text(
        {396, 92},
        std::to_string(rays.reached) + " of " + std::to_string(rays.sent) + " rays reach the light",
        {.color = blue, .anchor = Anchor::start});
    svg.text({396, 114}, "that share of its light is left", {.anchor = Anchor::start, .size = 13});
    return svg.source();
}

namespace {

/// Erratum 16: a light of radius 2 four above the ground, and half-way a strip two wide.
constexpr Light above{.position = {0, 4, 0}, .radius = 2};

bool free_of_strip(Vec3 from, Vec3 aim) {
    const Real half_way = (2 - from.y) / (aim.y - from.y);
    return std::abs(from.x + half_way * (aim.x - from.x)) > 1;
}

template <class Aim>
std::vector<Vec2> share_curve(const Aim& aim, const View& view) {
    constexpr std::uint32_t samples = 4096;
    std::vector<Vec2> curve;
    for (int i = -60; i <= 60; ++i) {
        const Vec3 from(Real(i) / 12, 0, 0);
        ShadowRays rays{.sent = samples};
        for (std::uint32_t k = 0; k < samples; ++k)
            if (free_of_strip(from, aim(from, spread_sample(k, 5)))) ++rays.reached;
        curve.push_back(view({from.x, visibility(rays), 0}));
    }
    return curve;
}

}  // namespace

std::string soft_shadow_penumbra() {
    Svg svg({640, 268}, "The share of the light that passes a strip, as printed and as it is");
    const View across{.place = {320, 206}, .scale = 56};
    // The share is drawn 150 pixels high.
    const View view{.place = across.place, .scale = 56, .up = {0, Real(150.0 / 56), 0}};
    for (const Real share : {Real(0), Real(0.5), Real(1)}) {
        svg.line(view({-5, share, 0}), view({5, share, 0}),
                 share == 0 ? Pen{.width = 1.5} : Pen{.color = faint, .width = 1});
        svg.text(view({-5, share, 0}) + Vec2(-8, 5), decimal(share, 1), {.anchor = Anchor::end});
    }
    svg.line(view({0, 0, 0}), view({0, Real(1.08), 0}), dashed);
    svg.line(view({-1, 0, 0}), view({1, 0, 0}), {.width = 6});
    svg.text({40, 24}, "the share of the light that arrives",
             {.anchor = Anchor::start, .size = 13});
    for (const int x : {-4, -2, 0, 2, 4})
        svg.text(view({x, 0, 0}) + Vec2(0, 24),
                 x < 0 ? "−" + std::to_string(-x) : std::to_string(x));
    svg.text({320, 254}, "$x$ on the ground; the strip above it from −1 to 1");
    const auto printed = [](Vec3, Vec2 sample) {
        return above.position + above.radius * Vec3(sample.x, sample.y, 0);  // z does not matter
    };
    const auto right = [](Vec3 from, Vec2 sample) { return sample_light(above, from, sample); };
    svg.polyline(share_curve(printed, view), {.color = purple, .width = 2, .dashes = "6 4"});
    svg.polyline(share_curve(right, view), {.color = blue, .width = 2.2});
    svg.text({560, 134}, "sample_light", {.color = blue});
    svg.text({92, 48}, "as printed", {.color = purple});
    return svg.source();
}

}  // namespace rt::figures
