// Stage 5: half-planes.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step05_triangle/triangle.hpp"

namespace rt::figures {

namespace {

constexpr Pen grid{.color = faint, .width = 1};

constexpr Triangle triangle{.a = {-1.05, -0.75, 0}, .b = {1.15, -0.5, 0}, .c = {-0.25, 0.95, 0}};
const std::vector<Vec3> box = {{-1.8, -1.15, 0}, {1.8, -1.15, 0}, {1.8, 1.2, 0}, {-1.8, 1.2, 0}};

void draw_outline(Sketch& sketch) {
    sketch.polygon({triangle.a, triangle.b, triangle.c}, none);
    for (const Vec3& p : {triangle.a, triangle.b, triangle.c}) sketch.mark(p, Mark::given);
    sketch.label(triangle.a, {-10, 14}, "$a$");
    sketch.label(triangle.b, {11, 12}, "$b$");
    sketch.label(triangle.c, {-12, -2}, "$c$");
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

/// Points all over the box, filled if `in` is true.
template <class In>
void draw_samples(Svg& svg, Sketch& sketch, std::string_view color, In in) {
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 10; ++column) {
            const Vec3 p(-1.62 + 0.36 * column, -0.98 + 0.335 * row, 0);
            const std::string_view fill = in(p) ? color : white;
            svg.circle(sketch(p), 2.2, fill, {.color = in(p) ? color : gray, .width = 1});
        }
}

/// The half-plane on the inner side of the edge from p to q, opposite to the vertex.
void draw_half_plane(Svg& svg, Vec2 place, Vec3 p, Vec3 q, int vertex, std::string_view name) {
    Sketch sketch(svg, {.place = place, .scale = 78});
    sketch.polygon(half_plane(box, vertex), pale_blue, no_pen);
    sketch.polygon(box, none, grid);
    draw_samples(svg, sketch, blue,
                 [=](Vec3 point) { return barycentric(triangle, point)[vertex] >= 0; });
    draw_outline(sketch);
    sketch.arrow(p, q, {.width = 3});
    svg.text(place - Vec2(0, 103), name);
}

void draw_triangle(Svg& svg, Vec2 place) {
    Sketch sketch(svg, {.place = place, .scale = 78});
    sketch.polygon(half_plane(half_plane(half_plane(box, 0), 1), 2), pale_red, no_pen);
    sketch.polygon(box, none, grid);
    draw_samples(svg, sketch, red, [](Vec3 point) {
        const Ray ray{.origin = point + Vec3(0, 0, 1), .direction = {0, 0, -1}};
        return intersect(ray, triangle, {}).has_value();
    });
    draw_outline(sketch);
    svg.text(place - Vec2(0, 103), "all three: the triangle");
}

}  // namespace

std::string triangle_half_planes() {
    Svg svg({640, 470}, "The three half-planes of a triangle, and what they have in common");
    const auto& [a, b, c] = triangle;
    draw_half_plane(svg, {168, 134}, a, b, 2, "$P_{a,b}$: ⟨$(b − a) ∧ (p − a)$, $n$⟩ ≥ 0");
    draw_half_plane(svg, {472, 134}, b, c, 0, "$P_{b,c}$: ⟨$(c − b) ∧ (p − b)$, $n$⟩ ≥ 0");
    draw_half_plane(svg, {168, 360}, c, a, 1, "$P_{c,a}$: ⟨$(a − c) ∧ (p − c)$, $n$⟩ ≥ 0");
    draw_triangle(svg, {472, 360});
    return svg.source();
}

}  // namespace rt::figures
