// Stages 1 and 2.
#include "docs/figures/figures.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"

#include <cmath>

namespace rt {

namespace {

/// A point of space on the page: x to the right, y upwards, z to the lower left.
Vec2 oblique(Vec3 p) {
    return {p.x - Real(0.45) * p.z, p.y - Real(0.35) * p.z};
}

void arrow(Svg& svg, Vec3 from, Vec3 to, const std::string& name, Look look, Vec2 offset) {
    svg.arrow(oblique(from), oblique(to), look);
    svg.label(oblique(to), name, offset);
}

}  // namespace

Svg pixel_grid() {
    const Resolution size{.width = 6, .height = 4};
    const Real fov = pi / 2;
    Svg svg({-2.1, -1.5}, {2.3, 1.55}, 140);
    const Real edge_x = Real(size.width) / Real(size.height);
    for (int i = 0; i <= size.height; ++i) {
        const Real y = 1 - 2 * Real(i) / Real(size.height);
        svg.segment({-edge_x, y}, {edge_x, y}, Look::thin);
    }
    for (int j = 0; j <= size.width; ++j) {
        const Real x = edge_x * (2 * Real(j) / Real(size.width) - 1);
        svg.segment({x, -1}, {x, 1}, Look::thin);
    }
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column)
            svg.dot(pixel_on_screen(pixel, size, fov), Look::ray);
    const Pixel marked{.row = 1, .column = 4};
    const Vec2 p = pixel_on_screen(marked, size, fov);
    svg.circle(p, Real(0.09), Look::bad);
    svg.label(p, "i = 1, j = 4", {-34, 18});
    for (int i = 0; i < size.height; ++i)
        svg.label({-edge_x, pixel_on_screen({.row = i, .column = 0}, size, fov).y},
                  std::to_string(i), {-22, -5});
    for (int j = 0; j < size.width; ++j)
        svg.label({pixel_on_screen({.row = 0, .column = j}, size, fov).x, 1}, std::to_string(j),
                  {-4, 10});
    svg.label({-edge_x, 1}, "i \\ j", {-44, 10});
    svg.arrow({0, 0}, {Real(1.9), 0}, Look::line);
    svg.label({Real(1.9), 0}, "x");
    svg.arrow({0, 0}, {0, Real(1.35)}, Look::line);
    svg.label({0, Real(1.35)}, "y");
    svg.label({-edge_x, -1}, "W = 6 columns, H = 4 rows; every ray goes through a centre",
              {0, -26});
    return svg;
}

Svg screen_side_view() {
    // Seen from the right: the page's x is −z.
    const Resolution size{.width = 6, .height = 6};
    const Real fov = pi / 3;
    Svg svg({-0.25, -0.85}, {1.75, 0.85}, 320);
    const Real top = std::tan(fov / 2);
    svg.arrow({0, 0}, {Real(1.65), 0}, Look::dashed);
    svg.label({Real(1.65), 0}, "−z", {-4, 8});
    for (int i = 0; i < size.height; ++i) {
        const Ray ray = camera_ray({.row = i, .column = 2}, size, fov);
        svg.arrow({0, 0}, Vec2(-ray.direction.z, ray.direction.y) * Real(1.35), Look::ray);
        svg.dot({-ray.direction.z, ray.direction.y}, Look::ray);
        svg.label(Vec2(-ray.direction.z, ray.direction.y) * Real(1.35), "i = " + std::to_string(i),
                  {6, -4});
    }
    svg.segment({0, 0}, {1, top}, Look::thin);
    svg.segment({0, 0}, {1, -top}, Look::thin);
    svg.segment({1, top}, {1, -top}, Look::shape);
    svg.label({1, -top}, "the screen, z = −1", {-60, -20});
    svg.label({1, top}, "tan(FOV / 2)", {-44, 10});
    std::vector<Vec2> arc;
    for (int k = -10; k <= 10; ++k) {
        const Real angle = fov / 2 * Real(k) / 10;
        arc.push_back(Vec2(std::cos(angle), std::sin(angle)) * Real(0.3));
    }
    svg.path(arc, Look::line);
    svg.label({Real(0.3), 0}, "FOV", {-36, 4});
    svg.dot({0, 0}, Look::line);
    svg.label({0, 0}, "o_r", {-24, -4});
    return svg;
}

Svg camera_axes() {
    const Vec3 direction(Real(0.6), Real(-0.3), Real(-0.75));
    const Basis basis = camera_basis(direction);
    Svg svg({-1.7, -1.15}, {1.75, 1.6}, 180);
    const Vec3 o(0);
    arrow(svg, o, {Real(1.35), 0, 0}, "x", Look::thin, {6, -4});
    arrow(svg, o, {0, Real(1.35), 0}, "y", Look::thin, {6, 0});
    arrow(svg, o, {0, 0, Real(1.6)}, "z", Look::thin, {-14, -10});
    arrow(svg, o, basis.x, "X", Look::bad, {8, -6});
    arrow(svg, o, basis.y, "Y = Z ∧ X", Look::good, {-30, 10});
    arrow(svg, o, basis.z, "Z = −c", Look::ray, {-20, 8});
    svg.arrow(oblique(o), oblique(-basis.z), Look::line);
    svg.label(oblique(-basis.z), "c", {4, -18});
    svg.dot(oblique(o), Look::line);
    svg.label(oblique(o), "o_C", {-8, -20});
    return svg;
}

Svg unnormalised_x() {
    // Over the pitch, in units of 30°.
    Svg svg({-0.55, -0.35}, {3.5, 1.35}, 160);
    svg.arrow({0, 0}, {Real(3.35), 0}, Look::line);
    svg.arrow({0, 0}, {0, Real(1.25)}, Look::line);
    std::vector<Vec2> printed;
    std::vector<Vec2> right;
    for (int degrees = 0; degrees <= 90; degrees += 2) {
        const Real pitch = Real(degrees) * pi / 180;
        const Vec3 direction(0, -std::sin(pitch), -std::cos(pitch));
        const Basis basis = camera_basis(direction);
        printed.push_back({Real(degrees) / 30, length(cross(Vec3(0, 1, 0), basis.z))});
        right.push_back({Real(degrees) / 30, length(basis.x)});
    }
    svg.path(right, Look::good);
    svg.path(printed, Look::bad);
    for (int k = 1; k <= 3; ++k) {
        svg.segment({Real(k), 0}, {Real(k), Real(0.04)}, Look::line);
        svg.label({Real(k), 0}, std::to_string(30 * k) + "°", {-10, -18});
    }
    svg.segment({2, 0}, {2, Real(0.5)}, Look::dashed);
    svg.segment({0, Real(0.5)}, {2, Real(0.5)}, Look::dashed);
    svg.label({0, Real(0.5)}, "0.5", {-28, -4});
    svg.label({0, 1}, "1", {-16, -4});
    svg.label({Real(1.9), 1}, "made unit length", {0, 10});
    svg.label({Real(0.5), Real(0.62)}, "as printed in MRT §2");
    svg.label({Real(3.1), 0}, "pitch", {0, 10});
    return svg;
}

}  // namespace rt
