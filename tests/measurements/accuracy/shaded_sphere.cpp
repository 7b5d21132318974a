#include "tests/measurements/accuracy/shaded_sphere.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step09_phong/phong.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rt {

namespace {

using Exact = long double;
using Vector = std::array<Exact, 3>;

constexpr int side = 256;  // pixels
constexpr Sphere ball{{0, 0, 0}, 1};
constexpr Vec3 eye{0, 0, 4};
constexpr Light lamp{.position = {3, 4, 5}};
constexpr Material shiny{.color = Color(1), .specular = 1, .shininess = 64};

/// The direction through the center of a pixel: numbers without a rounding.
Vec3 way(int row, int column) {
    const auto place = [](int i) { return Real(2 * i + 1 - side) / Real(2 * side); };
    return {place(column), place(row), Real(-1.5)};
}

Exact product(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector combined(Exact p, const Vector& a, Exact q, const Vector& b) {
    return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}
Vector unit(const Vector& a) {
    return combined(1 / std::sqrt(product(a, a)), a, 0, a);
}
Vector vector(Vec3 a) {
    return {a.x, a.y, a.z};
}

/// The diffuse and specular light, from 0 to 2, with the nearer root of |o + t d|² = 1.
std::optional<Exact> closed_form(Vec3 direction) {
    const Vector o = vector(eye);
    const Vector d = unit(vector(direction));
    const Exact b = product(o, d);
    const Exact root = b * b - product(o, o) + 1;
    if (root <= 0) return std::nullopt;
    const Vector n = combined(1, o, -b - std::sqrt(root), d);
    const Vector l = unit(combined(1, vector(lamp.position), -1, n));
    const Exact cosine = product(l, n);
    if (cosine <= 0) return 0;
    const Exact highlight = -product(combined(2 * cosine, n, -1, l), d);
    return cosine + std::pow(std::max<Exact>(highlight, 0), Exact(shiny.shininess));
}

std::optional<Exact> by_references(Vec3 direction) {
    const Ray ray{eye, direction};
    const auto t = intersect(ray, ball, Interval{});
    if (!t) return std::nullopt;
    const Vec3 point = at(ray, *t);
    const ShadingPoint surface{.point = point,
                               .normal = normal(ball, point),
                               .geometric_normal = normal(ball, point),
                               .to_eye = normalize(-direction),
                               .material = shiny};
    return Exact((diffuse_term(surface, lamp) + specular_term(surface, lamp)).r);
}

}  // namespace

ShadedSphere RT_PRECISION::shaded_sphere() {
    ShadedSphere most;
    for (int row = 1; row + 1 < side; ++row)
        for (int column = 1; column + 1 < side; ++column) {
            const auto seen = by_references(way(row, column));
            const auto right = closed_form(way(row, column));
            if (!seen || !right) continue;
            const bool is_inside =
                closed_form(way(row - 1, column)) && closed_form(way(row + 1, column)) &&
                closed_form(way(row, column - 1)) && closed_form(way(row, column + 1));
            double& error = is_inside ? most.inside : most.silhouette;
            error = std::max(error, double(255 * std::abs(*seen - *right)));
        }
    return most;
}

}  // namespace rt
