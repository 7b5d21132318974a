// Stage 5: half-planes, areas, and the edge that two triangles share.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step05_triangle/triangle.hpp"

#include <array>
#include <cmath>

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

namespace {

/// The three triangles between a point and the sides, each with its share of the area.
void draw_shares(Sketch& sketch, Vec3 p) {
    const auto& [a, b, c] = triangle;
    const Vec3 weights = barycentric(triangle, p);
    sketch.polygon({p, c, a}, pale_red, no_pen);
    sketch.polygon({p, a, b}, pale_green, no_pen);
    // Outside, the third triangle lies on the two others: hatched, so that the whole of each is
    // seen.
    if (weights.x < 0)
        for (int i = 1; i < 14; ++i)
            sketch.line(mix(p, b, Real(i) / 14), mix(p, c, Real(i) / 14),
                        {.color = amber, .width = 1});
    else
        sketch.polygon({p, b, c}, pale_blue, no_pen);
    for (const Vec3& vertex : {a, b, c}) sketch.line(p, vertex, dashed);
    draw_outline(sketch);
    sketch.mark(p, Mark::hit);
    const TextStyle style{.size = 13};
    const std::string alpha = "$α$ = " + decimal(weights.x, 2);
    if (weights.x < 0)
        sketch.label((p + c) / Real(2), {14, -10}, alpha, {.color = amber, .size = 13});
    else
        sketch.label((p + b + c) / Real(3), {-3, 5}, alpha, style);
    sketch.label((p + c + a) / Real(3), {6, 5}, "$β$ = " + decimal(weights.y, 2), style);
    sketch.label((p + a + b) / Real(3), {0, 5}, "$γ$ = " + decimal(weights.z, 2), style);
}

}  // namespace

std::string triangle_areas() {
    Svg svg({640, 326}, "The weights of a, b and c as shares of the triangle's area");
    const Vec3 inside(0, -0.2, 0);
    const Vec3 outside(1.1, 0.72, 0);
    const Vec3 unsigned_shares = abs(barycentric(triangle, outside));
    const Real sum = unsigned_shares.x + unsigned_shares.y + unsigned_shares.z;
    const TextStyle note{.color = gray, .size = 13};
    Sketch left(svg, {.place = {160, 142}, .scale = 118});
    draw_shares(left, inside);
    left.label(inside, {12, -8}, "$p$", {.color = red});
    Sketch right(svg, {.place = {466, 142}, .scale = 118});
    draw_shares(right, outside);
    right.label(outside, {12, -6}, "$p$", {.color = red});
    svg.text({160, 282}, "$p$ = $α a$ + $β b$ + $γ c$, and $α$ + $β$ + $γ$ = 1");
    svg.text({160, 304}, "the weight of a vertex: the part opposite to it", note);
    svg.text({480, 282}, "$α$ < 0: beyond the edge from $b$ to $c$");
    svg.text({480, 304}, "without their signs they sum to " + decimal(sum, 2), note);
    return svg.source();
}

namespace {

constexpr Resolution picture{.width = 10, .height = 10};
constexpr Real pixel_size = 24;
const Real fov = 2 * std::atan(Real(0.625));
/// A square of side 2 at z = −2, cut along a diagonal that contains pixel centers.
constexpr std::array quad = {Triangle{{-1, 1, -2}, {-1, -1, -2}, {1, -1, -2}},
                             Triangle{{-1, 1, -2}, {1, -1, -2}, {1, 1, -2}}};

/// True if the ray hits the triangle, with MRT's strict inequalities or without.
bool hits(const Ray& ray, const Triangle& half, bool strict) {
    const std::optional<Real> t = intersect(ray, half, {});
    if (!t) return false;
    const Vec3 weights = barycentric(half, at(ray, *t));
    return !strict || (weights.x > 0 && weights.y > 0 && weights.z > 0);
}

/// Both triangles, on the screen, over the picture.
void draw_quad_outline(Svg& svg, Vec2 corner) {
    const Vec2 step = pixel_on_screen({1, 1}, picture, fov) - pixel_on_screen({0, 0}, picture, fov);
    Sketch sketch(svg, {.place = corner + pixel_size * Vec2(5, 5), .scale = pixel_size / step.x});
    for (const auto& [a, b, c] : quad)
        sketch.polygon({a / -a.z, b / -b.z, c / -c.z}, none, {.width = 1.2});
}

/// The triangle of each pixel, and a ring at a pixel without one although its ray hits both.
void draw_quad(Svg& svg, Vec2 corner, bool strict, std::string_view title) {
    std::array<std::vector<Cell>, 2> hit;
    std::vector<Vec2> lost;
    for (Pixel pixel; pixel.row < picture.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < picture.width; ++pixel.column) {
            const Ray ray = camera_ray(pixel, picture, fov);
            const Vec2 place = corner + pixel_size * Vec2(pixel.column, pixel.row);
            if (hits(ray, quad[0], strict))
                hit[0].push_back({place, Vec2(pixel_size)});
            else if (hits(ray, quad[1], strict))
                hit[1].push_back({place, Vec2(pixel_size)});
            else if (hits(ray, quad[0], false))
                lost.push_back(place + Vec2(pixel_size / 2));
        }
    svg.cells(hit[0], pale_blue);
    svg.cells(hit[1], pale_amber);
    const Real side = pixel_size * picture.width;
    for (Real x = 0; x <= side; x += pixel_size) {
        svg.line(corner + Vec2(0, x), corner + Vec2(side, x), grid);
        svg.line(corner + Vec2(x, 0), corner + Vec2(x, side), grid);
    }
    draw_quad_outline(svg, corner);
    for (const Vec2& place : lost) svg.circle(place, 4, white, {.color = red});
    svg.text(corner + Vec2(side / 2, -12), title);
}

}  // namespace

std::string triangle_shared_edge() {
    Svg svg({640, 340}, "A square of two triangles: strict inequalities leave a crack");
    draw_quad(svg, {56, 42}, true, "> 0, as printed: the edge is nobody's");
    draw_quad(svg, {344, 42}, false, "≥ 0: the edge belongs to both");
    svg.circle({70, 309}, 4, white, {.color = red});
    svg.text({82, 314},
             "a ray through the pixel's center hits the shared edge, and neither triangle",
             {.color = gray, .anchor = Anchor::start, .size = 13});
    return svg.source();
}

}  // namespace rt::figures
