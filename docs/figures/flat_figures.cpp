// Stages 4, 5 and 6.
#include "docs/figures/figures.hpp"

#include "common/text.hpp"

#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace rt {

namespace {

Ray in_plane(Vec2 origin, Vec2 direction) {
    return {.origin = Vec3(origin, 0), .direction = Vec3(direction, 0)};
}

Vec2 on_page(const Ray& ray, Real t) {
    return Vec2(at(ray, t));
}

std::string hundredths(Real value) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

/// The triangle of the three figures of stage 5, in the plane of the page.
const Triangle shown{.a = {0, 0, 0}, .b = {4, Real(0.5), 0}, .c = {Real(1.2), 3, 0}};

void corners(Svg& svg) {
    svg.label(Vec2(shown.a), "a", {-16, -8});
    svg.label(Vec2(shown.b), "b", {10, -6});
    svg.label(Vec2(shown.c), "c", {-4, 10});
}

}  // namespace

Svg plane_lengths() {
    const Plane plane{.point = {Real(2.2), 0, 0}, .normal = {0, 1, 0}};
    const Ray ray = in_plane({-2, 2}, {Real(1.1), Real(-0.6)});
    const Real t = *intersect(ray, plane, {});
    Svg svg({-2.8, -0.5}, {3.2, 2.6}, 104);
    svg.segment({Real(-2.6), 0}, {3, 0}, Look::shape);
    svg.arrow(Vec2(ray.origin), on_page(ray, t), Look::thin);
    svg.arrow(Vec2(ray.origin), on_page(ray, 1), Look::ray);
    svg.label(on_page(ray, 1), "d_r", {4, 6});
    svg.segment(Vec2(ray.origin), {ray.origin.x, 0}, Look::dashed);
    svg.label({ray.origin.x, 1}, "⟨o − o_r, n⟩", {8, 0});
    const Vec2 tip = on_page(ray, 1);
    svg.segment(Vec2(ray.origin), {tip.x, ray.origin.y}, Look::dashed);
    svg.segment({tip.x, ray.origin.y}, tip, Look::good);
    svg.label({tip.x, ray.origin.y}, "⟨d_r, n⟩", {6, -28});
    svg.arrow(Vec2(plane.point), Vec2(plane.point) + Vec2(0, Real(0.8)), Look::line);
    svg.label(Vec2(plane.point) + Vec2(0, Real(0.8)), "n", {6, -4});
    svg.dot(Vec2(plane.point), Look::shape);
    svg.label(Vec2(plane.point), "o", {-4, -20});
    svg.dot(Vec2(ray.origin), Look::ray);
    svg.label(Vec2(ray.origin), "o_r", {-8, 10});
    svg.dot(on_page(ray, t), Look::good);
    svg.label(on_page(ray, t), "t = " + hundredths(t), {-30, -22});
    return svg;
}

Svg plane_horizon() {
    const Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};
    Svg svg({-0.6, -0.4}, {9.2, 1.9}, 64);
    svg.segment({Real(-0.4), 0}, {9, 0}, Look::shape);
    const Vec2 eye(0, 1);
    for (const Real slope : {Real(1), Real(0.5), Real(0.25), Real(0.125)}) {
        const Ray ray = in_plane(eye, {1, -slope});
        const Real t = *intersect(ray, ground, {});
        svg.segment(eye, on_page(ray, t), Look::ray);
        svg.dot(on_page(ray, t), Look::good);
        svg.label(on_page(ray, t), "t = " + text(t), {-16, -20});
    }
    svg.arrow(eye, {Real(8.8), 1}, Look::dashed);
    svg.label({Real(6), 1}, "the horizon: parallel", {0, 6});
    svg.arrow(eye, {4, Real(1.7)}, Look::bad);
    svg.label({4, Real(1.7)}, "misses", {8, -4});
    svg.dot(eye, Look::line);
    svg.label(eye, "o_r", {-26, -2});
    return svg;
}

Svg triangle_half_planes() {
    const Vec2 a(shown.a);
    const Vec2 b(shown.b);
    const Vec2 c(shown.c);
    Svg svg({-1.6, -1.0}, {5.6, 3.9}, 88);
    svg.polygon({a, b, c}, Look::shape);
    for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
        const Vec2 along = (to - from) / length(to - from);
        svg.segment(from - along * Real(0.8), to + along * Real(0.8), Look::dashed);
        const Vec2 middle = (from + to) / Real(2);
        svg.arrow(middle, middle + Vec2(-along.y, along.x) * Real(0.45), Look::good);
    }
    for (const Vec2& p :
         {Vec2(Real(1.7), Real(1.2)), Vec2(Real(3.4), Real(2.2)), Vec2(Real(-0.6), Real(1.1))}) {
        const Ray down{.origin = Vec3(p, 1), .direction = {0, 0, -1}};
        const bool hit = intersect(down, shown, {}).has_value();
        svg.dot(p, hit ? Look::good : Look::bad);
        svg.label(p, hit ? "inside all three" : "outside one", {-40, -22});
    }
    corners(svg);
    return svg;
}

Svg triangle_areas() {
    const Vec2 a(shown.a);
    const Vec2 b(shown.b);
    const Vec2 c(shown.c);
    const Vec2 p(Real(1.9), Real(1.0));
    const Vec3 weights = barycentric(shown, Vec3(p, 0));
    Svg svg({-0.9, -0.7}, {5.2, 3.6}, 104);
    svg.polygon({p, b, c}, Look::bad);
    svg.polygon({p, c, a}, Look::good);
    svg.polygon({p, a, b}, Look::ray);
    svg.label((p + b + c) / Real(3), "α = " + hundredths(weights.x), {-26, -4});
    svg.label((p + c + a) / Real(3), "β = " + hundredths(weights.y), {-34, -4});
    svg.label((p + a + b) / Real(3), "γ = " + hundredths(weights.z), {-26, -6});
    svg.dot(p, Look::line);
    svg.label(p, "p", {6, 8});
    corners(svg);
    return svg;
}

Svg triangle_shared_edge() {
    const Triangle lower{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 3, 0}};
    const Triangle upper{.a = {4, 3, 0}, .b = {0, 3, 0}, .c = {4, 0, 0}};
    Svg svg({-0.6, -0.7}, {6.4, 3.5}, 88);
    svg.polygon({Vec2(lower.a), Vec2(lower.b), Vec2(lower.c)}, Look::ray);
    svg.polygon({Vec2(upper.a), Vec2(upper.b), Vec2(upper.c)}, Look::good);
    int met = 0;
    for (int k = 0; k <= 8; ++k) {
        const Vec3 p = lower.b + Real(k) / 8 * (lower.c - lower.b);
        const Ray down{.origin = p + Vec3(0, 0, 1), .direction = {0, 0, -1}};
        const bool both = intersect(down, lower, {}) && intersect(down, upper, {});
        met += both ? 1 : 0;
        svg.dot(Vec2(p), both ? Look::shape : Look::bad);
    }
    svg.label({4, Real(1.5)}, std::to_string(met) + " rays at the edge:", {14, 10});
    svg.label({4, Real(1.5)}, "each meets both", {14, -10});
    svg.label({1, Real(0.7)}, "its neighbour", {-20, -6});
    svg.label({3, Real(2.5)}, "a triangle", {-10, -2});
    svg.label({0, 0}, "with > 0 in place of ≥ 0 each would meet neither", {0, -28});
    return svg;
}

Svg square_frame() {
    const Real c = Real(0.9397);  // turned by 20°
    const Real s = Real(0.3420);
    const Square square{
        .center = {0, 0, 0}, .basis = {.x = {c, s, 0}, .y = {-s, c, 0}, .z = {0, 0, 1}}, .side = 3};
    const auto place = [&square](Real x, Real y) {
        return Vec2(square.center + x * square.basis.x + y * square.basis.y);
    };
    const Vec2 p = place(Real(0.9), Real(0.6));
    const Vec2 uv = square_uv(square, Vec3(p, 0));
    const Vec2 corner = place(Real(-1.5), Real(-1.5));
    Svg svg({-3.2, -2.5}, {3.6, 2.6}, 92);
    svg.polygon({corner, place(Real(1.5), Real(-1.5)), place(Real(1.5), Real(1.5)),
                 place(Real(-1.5), Real(1.5))},
                Look::shape);
    svg.arrow({0, 0}, place(2, 0), Look::line);
    svg.label(place(2, 0), "X");
    svg.arrow({0, 0}, place(0, 2), Look::line);
    svg.label(place(0, 2), "Y", {8, -4});
    svg.segment(p, place(Real(0.9), 0), Look::dashed);
    svg.segment(p, place(0, Real(0.6)), Look::dashed);
    svg.label(place(Real(0.9), 0), "x", {2, -18});
    svg.label(place(0, Real(0.6)), "y", {-18, -2});
    svg.label(place(Real(1.5), 0), "h/2", {6, -20});
    svg.label(place(0, Real(1.5)), "h/2", {-36, -4});
    svg.arrow(corner, place(Real(1.5), Real(-1.5)), Look::ray);
    svg.arrow(corner, place(Real(-1.5), Real(1.5)), Look::good);
    svg.label(place(Real(0.4), Real(-1.5)), "U", {4, -20});
    svg.label(place(Real(-1.5), Real(0.4)), "V", {-22, 0});
    svg.dot(corner, Look::line);
    svg.label(corner, "C", {-18, -10});
    svg.dot({0, 0}, Look::shape);
    svg.label({0, 0}, "o", {-14, -16});
    svg.dot(p, Look::bad);
    svg.label(p, "P: u = " + hundredths(uv.x) + ", v = " + hundredths(uv.y), {8, 10});
    return svg;
}

Svg cornell_from_above() {
    // The page's y is −z: one looks in from below.
    const Square back{.center = {0, 0, -1}, .basis = {}, .side = 2};
    const Square front{.center = {0, 0, 1},
                       .basis = {.x = {-1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, -1}},
                       .side = 2,
                       .one_sided = true};
    const auto from_above = [](Vec3 p) { return Vec2(p.x, -p.z); };
    Svg svg({-2.9, -2.7}, {3.1, 1.6}, 104);
    for (const auto& [from, to] :
         {std::array<Vec2, 2>{{{-1, -1}, {-1, 1}}}, std::array<Vec2, 2>{{{-1, 1}, {1, 1}}},
          std::array<Vec2, 2>{{{1, 1}, {1, -1}}}})
        svg.segment(from, to, Look::shape);
    svg.segment({-1, -1}, {1, -1}, Look::bad);
    svg.arrow({Real(0.75), -1}, {Real(0.75), Real(-0.65)}, Look::bad);
    svg.label({Real(0.75), Real(-0.65)}, "n", {8, -8});
    svg.label({1, -1}, "the front, sides:1", {8, -4});
    const Ray in{.origin = {Real(-0.5), 0, Real(2.4)}, .direction = {Real(0.2), 0, -1}};
    const Real t_front = intersect(in, front, {}).value_or(infinity);
    const Real t_in = std::min(t_front, *intersect(in, back, {}));
    svg.arrow(from_above(in.origin), from_above(at(in, t_in)), Look::ray);
    svg.dot(from_above(in.origin), Look::ray);
    svg.dot(from_above(at(in, t_in)), Look::good);
    svg.label(from_above(at(in, t_in)), "⟨d, n⟩ > 0 at the front: through it, to the back",
              {-90, 12});
    const Ray out{.origin = {Real(0.5), 0, Real(-0.2)}, .direction = {Real(-0.25), 0, 1}};
    const Real t_out = *intersect(out, front, {});
    svg.arrow(from_above(out.origin), from_above(at(out, t_out)), Look::line);
    svg.dot(from_above(out.origin), Look::line);
    svg.dot(from_above(at(out, t_out)), Look::good);
    svg.label(from_above(at(out, t_out)), "from inside it is met", {-40, -22});
    return svg;
}

}  // namespace rt
