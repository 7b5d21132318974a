// Stage 9: a light behind the surface, and the effect of the exponent.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step09_phong/phong.hpp"

#include <cmath>

namespace rt::figures {

namespace {

const Vec3 up(0, 1, 0);

Vec3 tilted(Real degrees) {
    const Real angle = degrees * pi / 180;
    return {std::sin(angle), std::cos(angle), 0};
}

/// A small sun.
void draw_light(Sketch& sketch, Svg& svg, Vec3 place) {
    const Vec2 center = sketch(place);
    for (int i = 0; i < 8; ++i) {
        const Real angle = Real(i) * pi / 4;
        const Vec2 beam(std::cos(angle), std::sin(angle));
        svg.line(center + Real(10) * beam, center + Real(15) * beam, {.color = amber, .width = 2});
    }
    svg.circle(center, 7, "#ffd45c", {.color = amber});
}

/// An eye that looks against the direction.
void draw_eye(Sketch& sketch, Svg& svg, Vec3 place, Vec3 to_eye) {
    const Vec2 center = sketch(place);
    const Vec2 back(to_eye.x, -to_eye.y);
    const Vec2 beside(back.y, -back.x);
    const Vec2 apex = center + Real(16) * back;
    svg.polyline({center + Real(9) * beside, apex, center - Real(9) * beside},
                 {.color = ink, .width = 2});
    svg.circle(center + Real(4) * back, 4, ink, no_pen);
}

void draw_ground(Sketch& sketch, Real from, Real to) {
    constexpr Real depth = 0.16;
    sketch.polygon({{from, 0, 0}, {to, 0, 0}, {to, -depth, 0}, {from, -depth, 0}}, tint, no_pen);
    sketch.line({from, 0, 0}, {to, 0, 0}, {.width = 2});
}

void draw_vector(Sketch& sketch, Vec3 v, std::string_view color, std::string_view name,
                 Vec2 offset) {
    sketch.arrow(Vec3(0), v, {.color = color, .width = 2.2});
    sketch.label(v, offset, name, {.color = color, .size = 16, .bold = true});
}

}  // namespace

std::string phong_behind() {
    Svg svg({640, 290}, "A light behind the surface, whose reflection is within 90° of the eye");
    Sketch sketch(svg, {.place = {330, 150}, .scale = 120});
    // The numbers of erratum 14, with its z upright.
    const Vec3 l(Real(0.8), Real(-0.6), 0);
    const Vec3 v(Real(-0.8), Real(0.6), 0);
    const Vec3 r = reflected(l, up);
    draw_ground(sketch, -Real(1.9), Real(1.9));
    sketch.line(l, Real(1.3) * l, dashed);
    sketch.line(v, Real(1.3) * v, dashed);
    sketch.angle(Vec3(0), v, r, 50, {.width = 1.4});
    draw_vector(sketch, up, green, "$N$", {0, -8});
    draw_vector(sketch, l, amber, "$L$", {14, -4});
    draw_vector(sketch, r, amber, "$R$", {-14, 8});
    draw_vector(sketch, v, blue, "$V$", {2, -10});
    draw_light(sketch, svg, Real(1.42) * l);
    draw_eye(sketch, svg, Real(1.36) * v, v);
    sketch.mark(Vec3(0), Mark::refused);
    sketch.label(Vec3(-Real(0.6), 0, 0), {0, -7}, "$α$");
    const TextStyle beside{.anchor = Anchor::start};
    svg.text({400, 40}, "⟨$L$, $N$⟩ = " + decimal(dot(l, up), 2) + ": no light comes", beside);
    svg.text({400, 64}, "⟨$R$, $V$⟩ = " + decimal(dot(r, v), 2) + ": and no highlight", beside);
    return svg.source();
}

std::string phong_highlight() {
    constexpr Vec2 corner(70, 262);  // α = −90°, 0
    constexpr Vec2 size(500, 222);
    constexpr int limit = 90;
    Svg svg({640, 318}, "The highlight by the angle between R and V, for five exponents");
    const auto place = [&](Real degrees, Real value) {
        return corner + Vec2((degrees + limit) / (2 * limit) * size.x, -value * size.y);
    };
    for (const Real value : {Real(0), Real(0.5), Real(1)}) {
        svg.line(place(-limit, value), place(limit, value), {.color = faint, .width = 1});
        svg.text(place(-limit, value) + Vec2(-8, 5), decimal(value, 1),
                 {.color = gray, .anchor = Anchor::end, .size = 13});
    }
    for (int degrees = -limit; degrees <= limit; degrees += 30) {
        svg.line(place(Real(degrees), 0), place(Real(degrees), 0) + Vec2(0, 5), thin);
        svg.text(place(Real(degrees), 0) + Vec2(0, 22),
                 (degrees < 0 ? "−" : "") + std::to_string(std::abs(degrees)) + "°",
                 {.color = gray, .size = 13});
    }
    svg.text(place(0, 0) + Vec2(0, 44), "$α$, between $R$ and $V$");

    struct Curve {
        int shininess;
        std::string_view color;
    };
    const Light light{.position = Real(4) * up};  // straight above: R = L = N
    Vec2 key(520, 56);
    svg.text(key, "cos$^n$ $α$", {.size = 16});
    for (const Curve& curve :
         {Curve{2, purple}, Curve{8, blue}, Curve{32, green}, Curve{128, amber}, Curve{512, red}}) {
        std::vector<Vec2> points;
        for (int i = -2 * limit; i <= 2 * limit; ++i) {
            const Real degrees = Real(i) / 2;
            const ShadingPoint surface{
                .point = Vec3(0),
                .normal = up,
                .geometric_normal = up,
                .to_eye = tilted(degrees),
                .material = {.specular = 1, .shininess = Real(curve.shininess)}};
            points.push_back(place(degrees, specular_term(surface, light).x));
        }
        svg.polyline(points, {.color = curve.color, .width = 1.8});
        key.y += 22;
        svg.text(key, "$n$ = " + std::to_string(curve.shininess), {.color = curve.color});
    }
    return svg.source();
}

}  // namespace rt::figures
