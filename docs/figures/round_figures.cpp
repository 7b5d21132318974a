// Stages 3, 7 and 8: in the plane z = 0 of the page, unless a figure says otherwise.
#include "docs/figures/figures.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include <cmath>

namespace rt {

namespace {

Ray in_plane(Vec2 origin, Vec2 direction) {
    return {.origin = Vec3(origin, 0), .direction = Vec3(direction, 0)};
}

/// Every t at which the ray meets the shape, in order.
template <class Shape>
std::vector<Real> all_hits(const Ray& ray, const Shape& shape, Real from = 0) {
    std::vector<Real> found;
    Interval interval{.min = from, .max = infinity};
    while (const auto t = intersect(ray, shape, interval)) {
        found.push_back(*t);
        interval.min = *t + Real(1e-9);  // past the hit
    }
    return found;
}

Vec2 on_page(const Ray& ray, Real t) {
    return Vec2(at(ray, t));
}

}  // namespace

Svg sphere_roots() {
    const Sphere sphere{.center = {0, 0, 0}, .radius = 1};
    Svg svg({-3.3, -1.75}, {3.0, 1.85}, 104);
    svg.circle({0, 0}, 1, Look::shape);
    svg.dot({0, 0}, Look::shape);
    svg.label({0, 0}, "o");
    struct Line {
        Vec2 origin;
        Vec2 direction;
        Real length;
        const char* name;
    };
    const Line lines[] = {
        {{-3, Real(1.5)}, {1, 0}, Real(5.4), "passes by: no real t"},
        {{-3, 1}, {1, 0}, Real(5.4), "touches: one t"},
        {{-3, Real(0.45)}, {1, 0}, Real(5.4), "from outside: the smaller t"},
        {{Real(-0.35), Real(-0.2)}, {1, 0}, Real(2.75), "from inside: the positive t"},
        {{Real(1.35), Real(-0.8)}, {1, Real(-0.1)}, Real(1.1), "behind: both t negative"},
    };
    for (const auto& [origin, direction, length, name] : lines) {
        const Ray ray = in_plane(origin, direction);
        svg.arrow(origin, on_page(ray, length), Look::ray);
        svg.dot(origin, Look::ray);
        bool first = true;
        for (const Real t : all_hits(ray, sphere, -infinity)) {
            if (t < 0) continue;
            svg.dot(on_page(ray, t), first ? Look::good : Look::thin);
            first = false;
        }
    }
    svg.label({-3, Real(1.5)}, lines[0].name, {6, 8});
    svg.label({-3, 1}, lines[1].name, {6, 8});
    svg.label({-3, Real(0.45)}, lines[2].name, {6, 8});
    svg.label({Real(1.05), Real(-0.2)}, lines[3].name, {0, 8});
    svg.label({Real(1.35), Real(-0.8)}, lines[4].name, {-8, -30});
    svg.segment(on_page(in_plane(lines[4].origin, lines[4].direction), -2), lines[4].origin,
                Look::dashed);
    return svg;
}

Svg sphere_half_chord() {
    const Sphere sphere{.center = {0, 0, 0}, .radius = 1};
    const Ray ray = in_plane({-2.6, Real(0.2)}, {1, Real(0.16)});
    const auto hits = all_hits(ray, sphere);
    const Real closest = (hits[0] + hits[1]) / 2;  // half-way between the two roots
    Svg svg({-3.0, -1.25}, {2.2, 1.35}, 120);
    svg.circle({0, 0}, 1, Look::shape);
    svg.arrow(Vec2(ray.origin), on_page(ray, Real(4.6)), Look::ray);
    svg.segment({0, 0}, on_page(ray, closest), Look::dashed);
    svg.segment({0, 0}, on_page(ray, hits[1]), Look::line);
    svg.segment(on_page(ray, closest), on_page(ray, hits[1]), Look::good);
    for (const Real t : hits) svg.dot(on_page(ray, t), Look::good);
    svg.dot(on_page(ray, closest), Look::bad);
    svg.dot({0, 0}, Look::shape);
    svg.dot(Vec2(ray.origin), Look::ray);
    svg.label(Vec2(ray.origin), "o_r", {-6, -20});
    svg.label({0, 0}, "o", {-4, -18});
    svg.label(on_page(ray, closest), "t_0", {-4, 10});
    svg.label(on_page(ray, hits[0]), "t_1", {-18, 10});
    svg.label(on_page(ray, hits[1]), "t_2", {10, -6});
    svg.label(on_page(ray, closest) / Real(2), "q", {-16, -4});
    svg.label(on_page(ray, hits[1]) / Real(2), "r", {4, -14});
    svg.label(on_page(ray, (closest + hits[1]) / 2), "half the chord", {-30, 22});
    return svg;
}

Svg cylinder_section() {
    // Left: along the axis. Right: from the side, with the axis upwards.
    const Cylinder cylinder{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    const Ray ray{.origin = {-2, Real(1.1), Real(-0.35)},
                  .direction = {1, Real(-0.35), Real(0.12)}};
    const auto hits = all_hits(ray, cylinder);
    Svg svg({-2.4, -1.75}, {5.9, 1.75}, 78);
    const auto from_above = [](Vec3 p) { return Vec2(p.x, -p.z); };
    const auto from_side = [](Vec3 p) { return Vec2(p.x + Real(3.9), p.y); };
    svg.circle({0, 0}, 1, Look::shape);
    svg.dot({0, 0}, Look::shape);
    svg.label({0, 0}, "o", {6, -16});
    svg.arrow(from_above(ray.origin), from_above(at(ray, Real(3.9))), Look::ray);
    const Vec2 c = from_side(Vec3(0));
    svg.polygon({c + Vec2(-1, -1), c + Vec2(1, -1), c + Vec2(1, 1), c + Vec2(-1, 1)}, Look::shape);
    svg.segment(c + Vec2(0, Real(-1.4)), c + Vec2(0, Real(1.35)), Look::dashed);
    svg.label(c + Vec2(0, Real(1.35)), "Z", {6, -2});
    svg.dot(c, Look::shape);
    svg.arrow(from_side(ray.origin), from_side(at(ray, Real(3.6))), Look::ray);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Vec3 p = at(ray, hits[i]);
        const std::string name = "t_" + std::to_string(i + 1);
        svg.dot(from_above(p), Look::good);
        svg.label(from_above(p), name, i == 0 ? Vec2(-22, 6) : Vec2(8, 4));
        svg.dot(from_side(p), Look::good);
        svg.label(from_side(p), name, i == 0 ? Vec2(-20, 6) : Vec2(8, 4));
    }
    svg.label(c + Vec2(1, 1), "h/2", {6, -8});
    svg.label(c + Vec2(1, -1), "−h/2", {6, 0});
    const Vec2 second = from_side(at(ray, hits[1]));
    svg.segment({c.x, second.y}, second, Look::line);
    svg.label({c.x, second.y}, "z_p", {-28, -8});
    svg.label({-1, -1}, "along the axis: a circle of radius r", {-90, -40});
    svg.label(c + Vec2(-1, -1), "from the side: how high is the hit?", {-30, -40});
    return svg;
}

Svg cylinder_both_roots() {
    const Cylinder cylinder{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    const Cylinder endless{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 9};
    const Ray ray = in_plane({Real(-2.6), Real(2.2)}, {1, Real(-0.55)});
    const auto on_circle = all_hits(ray, endless);
    const auto on_side = intersect(ray, cylinder, {});
    Svg svg({-3.1, -1.4}, {2.6, 2.5}, 110);
    svg.segment({-1, Real(2.3)}, {-1, 1}, Look::dashed);
    svg.segment({1, Real(2.3)}, {1, 1}, Look::dashed);
    svg.segment({-1, -1}, {-1, 1}, Look::shape);
    svg.segment({1, -1}, {1, 1}, Look::shape);
    svg.arrow(Vec2(ray.origin), on_page(ray, Real(4.8)), Look::ray);
    svg.dot(Vec2(ray.origin), Look::ray);
    svg.dot(on_page(ray, on_circle[0]), Look::bad);
    svg.label(on_page(ray, on_circle[0]), "t_1: z_p > h/2, beyond the rim", {8, 8});
    svg.dot(on_page(ray, *on_side), Look::good);
    svg.label(on_page(ray, *on_side), "t_2: the inside of the far wall", {-200, -18});
    svg.label({1, 1}, "h/2", {8, -6});
    svg.label({1, -1}, "−h/2", {8, 0});
    svg.label(Vec2(ray.origin), "o_r", {-8, 10});
    return svg;
}

Svg cone_side() {
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    const Cone nappe{.apex = {0, 0, 0}, .axis = {0, -1, 0}, .radius = 1, .height = 2};
    const Ray ray = in_plane({Real(-0.62), Real(-1.45)}, {Real(0.3), 1});
    const auto lower = intersect(ray, nappe, {});
    const auto upper = intersect(ray, cone, {});
    Svg svg({-2.9, -1.6}, {2.9, 2.5}, 110);
    svg.segment({0, 0}, {Real(-0.75), Real(-1.5)}, Look::dashed);
    svg.segment({0, 0}, {Real(0.75), Real(-1.5)}, Look::dashed);
    svg.polygon({{0, 0}, {1, 2}, {-1, 2}}, Look::shape);
    svg.segment({0, Real(-1.4)}, {0, Real(2.35)}, Look::thin);
    svg.label({0, Real(2.35)}, "Z", {6, -4});
    svg.segment({0, 2}, {1, 2}, Look::line);
    svg.label({Real(0.5), 2}, "r", {-2, 6});
    svg.segment({Real(1.35), 0}, {Real(1.35), 2}, Look::line);
    svg.label({Real(1.35), 1}, "h", {8, -4});
    svg.segment({0, 0}, {Real(1.35), 0}, Look::thin);
    svg.segment({1, 2}, {Real(1.35), 2}, Look::thin);
    svg.arrow(Vec2(ray.origin), on_page(ray, Real(3.4)), Look::ray);
    svg.dot(Vec2(ray.origin), Look::ray);
    svg.label(Vec2(ray.origin), "o_r", {-26, -6});
    svg.dot(on_page(ray, *lower), Look::bad);
    svg.label(on_page(ray, *lower), "z_p < 0: refused", {-130, -4});
    svg.dot(on_page(ray, *upper), Look::good);
    svg.label(on_page(ray, *upper), "the hit", {-58, 6});
    svg.dot({0, 0}, Look::shape);
    svg.label({0, 0}, "o, the apex", {12, -18});
    return svg;
}

Svg cone_coefficient() {
    // r = 1, h = 2: how wide the cone is at each height, asked with rays across.
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    std::vector<Vec2> right;
    std::vector<Vec2> printed;
    for (int k = 0; k <= 50; ++k) {
        const Real z = 2 * Real(k) / 50;
        const Ray across = in_plane({5, z}, {-1, 0});
        right.push_back(on_page(across, *intersect(across, cone, {})));
        // The printed x² = (r / h) z², which is a cone of the radius √(r h).
        const Cone as_printed{
            .apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = std::sqrt(Real(2)), .height = 2};
        printed.push_back(on_page(across, *intersect(across, as_printed, {})));
    }
    Svg svg({-0.6, -0.35}, {3.5, 2.4}, 150);
    svg.segment({0, 0}, {0, Real(2.25)}, Look::dashed);
    svg.label({0, Real(2.25)}, "Z", {6, -4});
    svg.path(right, Look::good);
    svg.path(printed, Look::bad);
    svg.segment({0, 2}, right.back(), Look::thin);
    svg.segment(right.back(), printed.back(), Look::thin);
    svg.label(right.back(), "1", {-4, 10});
    svg.label(printed.back(), "1.414", {-12, 10});
    svg.label({0, 2}, "z = h", {-46, -4});
    svg.label(right[22], "(r/h)² z²", {-84, 2});
    svg.label(printed[25], "r/h z², as printed in MRT §8", {12, -6});
    svg.dot({0, 0}, Look::line);
    svg.label({0, 0}, "o", {-18, -6});
    return svg;
}

}  // namespace rt
