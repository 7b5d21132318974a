// Stage 5: half-planes, areas, and the edge that two triangles share.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step05_triangle/triangle.hpp"

#include <array>
#include <cmath>

namespace rt::figures {

namespace {

constexpr Triangle triangle{.a = {-1.05, -0.75, 0}, .b = {1.15, -0.5, 0}, .c = {-0.25, 0.95, 0}};
constexpr std::string_view pale_blue = "#d5e5f3";
constexpr std::string_view pale_red = "#f6dcd6";
constexpr std::string_view pale_green = "#d9ebdf";
constexpr std::string_view pale_amber = "#f8e3b8";

void draw_vertices(Sketch& sketch) {
    sketch.polygon({triangle.a, triangle.b, triangle.c}, none);
    for (const Vec3& p : {triangle.a, triangle.b, triangle.c}) sketch.mark(p, Mark::given);
    sketch.label(triangle.a, {-8, 16}, "$a$");
    sketch.label(triangle.b, {11, 12}, "$b$");
    sketch.label(triangle.c, {-10, -4}, "$c$");
}

/// The part of a convex polygon where the weight of one vertex is not negative: a half-plane.
std::vector<Vec3> half_plane(const std::vector<Vec3>& polygon, int vertex) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 p = polygon[i];
        const Vec3 q = polygon[(i + 1) % polygon.size()];
        const Real at_p = barycentric(triangle, p)[vertex];
        const Real at_q = barycentric(triangle, q)[vertex];
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) != (at_q >= 0)) kept.push_back(mix(p, q, at_p / (at_p - at_q)));
    }
    return kept;
}

const std::vector<Vec3> box = {{-1.8, -1.15, 0}, {1.8, -1.15, 0}, {1.8, 1.2, 0}, {-1.8, 1.2, 0}};

/// Points on a lattice over the box.
std::vector<Vec3> lattice() {
    std::vector<Vec3> points;
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 12; ++column)
            points.emplace_back(-1.65 + 0.3 * column, -1.02 + 0.26 * row, 0);
    return points;
}

/// The half-plane on the inner side of the edge from p to q, opposite to the vertex.
void draw_half_plane(Svg& svg, Vec2 place, Vec3 p, Vec3 q, int vertex, std::string_view name) {
    Sketch sketch(svg, {.place = place, .scale = 78});
    sketch.polygon(half_plane(box, vertex), pale_blue, no_pen);
    for (const Vec3& point : lattice()) {
        const bool in = barycentric(triangle, point)[vertex] >= 0;
        svg.circle(sketch(point), 2, in ? blue : white, {.color = in ? blue : gray, .width = 1});
    }
    sketch.polygon(box, none, {.color = faint, .width = 1});
    draw_vertices(sketch);
    sketch.arrow(p, q, {.width = 3});
    svg.text(place - Vec2(0, 104), name);
}

void draw_all_three(Svg& svg, Vec2 place) {
    Sketch sketch(svg, {.place = place, .scale = 78});
    sketch.polygon(half_plane(half_plane(half_plane(box, 0), 1), 2), pale_red, no_pen);
    for (const Vec3& point : lattice()) {
        const bool in =
            intersect({.origin = point + Vec3(0, 0, 1), .direction = {0, 0, -1}}, triangle, {})
                .has_value();
        svg.circle(sketch(point), 2, in ? red : white, {.color = in ? red : gray, .width = 1});
    }
    sketch.polygon(box, none, {.color = faint, .width = 1});
    draw_vertices(sketch);
    svg.text(place - Vec2(0, 104), "all three: what `intersect` meets");
}

}  // namespace

std::string triangle_half_planes() {
    Svg svg({640, 480}, "The three half-planes of a triangle, and what they have in common");
    const auto& [a, b, c] = triangle;
    draw_half_plane(svg, {168, 132}, a, b, 2, "$P_{a,b}$: ⟨$(b − a) ∧ (p − a)$, $n$⟩ ≥ 0");
    draw_half_plane(svg, {472, 132}, b, c, 0, "$P_{b,c}$: ⟨$(c − b) ∧ (p − b)$, $n$⟩ ≥ 0");
    draw_half_plane(svg, {168, 364}, c, a, 1, "$P_{c,a}$: ⟨$(a − c) ∧ (p − c)$, $n$⟩ ≥ 0");
    draw_all_three(svg, {472, 364});
    return svg.source();
}

namespace {

/// The three triangles that a point makes with the sides, each with its share of the whole.
void draw_shares(Sketch& sketch, Vec3 p) {
    const auto& [a, b, c] = triangle;
    const Vec3 weights = barycentric(triangle, p);
    sketch.polygon({p, c, a}, pale_red, no_pen);
    sketch.polygon({p, a, b}, pale_green, no_pen);
    sketch.polygon({p, b, c}, weights.x < 0 ? pale_amber : pale_blue, no_pen);
    for (const Vec3& vertex : {a, b, c}) sketch.line(p, vertex, dashed);
    draw_vertices(sketch);
    sketch.mark(p, Mark::hit);
    sketch.label((p + b + c) / Real(3), {0, 5}, "$α$ = " + decimal(weights.x, 2));
    sketch.label((p + c + a) / Real(3), {0, 5}, "$β$ = " + decimal(weights.y, 2));
    sketch.label((p + a + b) / Real(3), {0, 5}, "$γ$ = " + decimal(weights.z, 2));
}

}  // namespace

std::string triangle_areas() {
    Svg svg({640, 320}, "The weights of a, b and c as shares of the triangle's area");
    Sketch inside(svg, {.place = {150, 150}, .scale = 118});
    draw_shares(inside, {-0.2, -0.15, 0});
    Sketch outside(svg, {.place = {460, 150}, .scale = 118});
    draw_shares(outside, {0.9, 0.6, 0});
    return svg.source();
}

namespace {

constexpr int pixels = 10;
const Real quad_fov = 2 * std::atan(Real(0.625));
/// A square of side 2 at z = −2, cut along a diagonal on which pixel centres lie.
constexpr std::array quad = {Triangle{{-1, 1, -2}, {-1, -1, -2}, {1, -1, -2}},
                             Triangle{{-1, 1, -2}, {1, -1, -2}, {1, 1, -2}}};

/// Whether the ray meets the triangle, with MRT's strict inequalities or without.
bool meets(const Ray& ray, const Triangle& half, bool strict) {
    const std::optional<Real> t = intersect(ray, half, {});
    if (!t) return false;
    const Vec3 weights = barycentric(half, at(ray, *t));
    return !strict || (weights.x > 0 && weights.y > 0 && weights.z > 0);
}

void draw_quad(Svg& svg, Vec2 corner, bool strict, std::string_view title) {
    constexpr Real size = 24;
    for (int i = 0; i < pixels; ++i)
        for (int j = 0; j < pixels; ++j) {
            const Ray ray = camera_ray({i, j}, {pixels, pixels}, quad_fov);
            const bool first = meets(ray, quad[0], strict);
            const bool second = meets(ray, quad[1], strict);
            const Vec2 place = corner + size * Vec2(j, i);
            if (first || second) svg.cell(place, Vec2(size), first ? pale_blue : pale_amber);
            svg.polygon({place, place + Vec2(size, 0), place + Vec2(size), place + Vec2(0, size)},
                        none, {.color = faint, .width = 1});
        }
    svg.text(corner + Vec2(size * pixels / 2, -12), title);
}

}  // namespace

std::string triangle_shared_edge() {
    Svg svg({640, 330}, "A square of two triangles: strict inequalities leave a crack");
    draw_quad(svg, {52, 48}, true, "strict, > 0: a crack");
    draw_quad(svg, {348, 48}, false, "edges belong, ≥ 0");
    return svg.source();
}

}  // namespace rt::figures
