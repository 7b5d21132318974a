// Stage 7: a cylinder along its axis and from the side.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step07_cylinder/cylinder.hpp"

namespace rt::figures {

namespace {

/// The same tube without ends, whose roots are those of the quadratic.
Cylinder endless(Cylinder cylinder) {
    cylinder.height = 100;
    return cylinder;
}

/// The point of the side at a height z, in a direction across the axis.
Vec3 side_point(const Cylinder& cylinder, Real z, Vec3 across) {
    const Ray ray{.origin = cylinder.center + z * cylinder.axis, .direction = across};
    return first_hit(ray, endless(cylinder));
}

/// The outline seen across the axis, and its extension without ends.
void draw_side(Sketch& sketch, const Cylinder& cylinder, Vec3 x, Real reach) {
    const Real half = cylinder.height / 2;
    const auto left = [&](Real z) { return side_point(cylinder, z, -x); };
    const auto right = [&](Real z) { return side_point(cylinder, z, x); };
    sketch.polygon({left(-half), right(-half), right(half), left(half)}, tint, no_pen);
    sketch.line(left(-reach), left(reach), dashed);
    sketch.line(right(-reach), right(reach), dashed);
    sketch.line(left(-half), left(half), {.width = 2});
    sketch.line(right(-half), right(half), {.width = 2});
    sketch.line(left(half), right(half), {.color = gray, .width = 1});
    sketch.line(left(-half), right(-half), {.color = gray, .width = 1});
}

/// Marks the roots of the endless tube: the hit of the real one, and the rejected roots.
void mark_roots(Sketch& sketch, const Ray& ray, const Cylinder& cylinder) {
    const std::optional<Real> hit = intersect(ray, cylinder, {});
    for (const Real t : all_roots(ray, endless(cylinder)))
        sketch.mark(at(ray, t), t == hit ? Mark::hit : Mark::refused);
}

constexpr Cylinder tube{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 1.7};

void draw_section(Svg& svg, Vec2 place, const Basis& basis, const Ray& ray) {
    Sketch sketch(svg, {.place = place, .scale = 82, .right = basis.x, .up = basis.y});
    const Vec2 rim = sketch(side_point(tube, 0, basis.x));
    const std::vector<Real> roots = all_roots(ray, endless(tube));
    const Vec3 p = first_hit(ray, tube);
    svg.circle(place, distance(place, rim), tint, {.width = 2});
    sketch.arrow(tube.center, tube.center + Real(1.4) * basis.x, {.color = green, .width = 1.5});
    sketch.arrow(tube.center, tube.center + Real(1.4) * basis.y, {.color = green, .width = 1.5});
    const Vec3 rim_point = side_point(tube, 0, -basis.x - basis.y);
    sketch.arrow(tube.center, rim_point, thin);
    sketch.ray(ray, Real(3.5));
    sketch.normal(p, normal(tube, p), 34);
    sketch.mark(tube.center, Mark::given);
    sketch.mark(ray.origin, Mark::given);
    mark_roots(sketch, ray, tube);
    const TextStyle of_axis{.color = green};
    const TextStyle of_root{.color = red};
    sketch.label(Real(1.4) * basis.x, {10, 5}, "$X$", of_axis);
    sketch.label(Real(1.4) * basis.y, {14, 8}, "$Y$", of_axis);
    sketch.label(rim_point / Real(2), {10, 10}, "$r$");
    sketch.label(ray.origin, {0, -12}, "$o_R$");
    sketch.label(at(ray, roots[0]), {14, 18}, "$t_1$", of_root);
    sketch.label(at(ray, roots[1]), {14, 18}, "$t_2$", of_root);
    svg.text(place + Vec2(0, 146), "along $Z$: $x_p$² + $y_p$² = $r$²");
}

/// Across the axis: the heights decide.
void draw_heights(Svg& svg, Vec2 place, const Basis& basis, const Ray& ray) {
    Sketch sketch(svg, {.place = place, .scale = 82, .right = basis.x, .up = basis.z});
    const Real half = tube.height / 2;
    constexpr Real edge = 1.55;
    const TextStyle after{.anchor = Anchor::start};
    draw_side(sketch, tube, basis.x, Real(1.4));
    sketch.arrow(tube.center, tube.center + Real(1.4) * basis.z, {.color = green, .width = 1.5});
    for (const Real z : {half, -half}) {
        sketch.line(side_point(tube, z, basis.x), {edge, z, 0}, dashed);
        sketch.label({edge, z, 0}, {6, 5}, z > 0 ? "$h$ / 2" : "−$h$ / 2", after);
    }
    for (const Real t : all_roots(ray, endless(tube))) {
        const Vec3 p = at(ray, t);
        const bool is_hit = t == intersect(ray, tube, {});
        sketch.line(p, {edge, dot(p - tube.center, tube.axis), 0},
                    {.color = red, .width = 1, .dashes = "2 4"});
        sketch.label({edge, dot(p - tube.center, tube.axis), 0}, {6, 5},
                     is_hit ? "$z_p$ of $t_2$" : "$z_p$ of $t_1$",
                     {.color = red, .anchor = Anchor::start});
    }
    sketch.ray(ray, Real(3.4));
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(tube.center, Mark::given);
    mark_roots(sketch, ray, tube);
    sketch.label(tube.center, {-10, 5}, "$o$");
    sketch.label(Real(1.4) * basis.z, {13, 8}, "$Z$", {.color = green});
    sketch.label(ray.origin, {-8, 5}, "$o_R$", {.anchor = Anchor::end});
    svg.text(place + Vec2(0, 146), "from the side: |$z_p$| ≤ $h$ / 2");
}

}  // namespace

std::string cylinder_section() {
    Svg svg({640, 330}, "A cylinder and one ray, seen along the axis and from the side");
    const Basis basis = orthonormal_basis(tube.axis);
    const auto in_frame = [&basis](Vec3 v) {
        return v.x * basis.x + v.y * basis.y + v.z * basis.z;
    };
    const Ray ray{.origin = in_frame({-1.75, -0.35, 1.6}), .direction = in_frame({1, 0.3, -0.6})};
    draw_section(svg, {170, 158}, basis, ray);
    draw_heights(svg, {446, 158}, basis, ray);
    return svg.source();
}

}  // namespace rt::figures
