// Errata of HAI and PHY: see tests/documents/errata.hpp.
#include "steps/step04_plane/plane.hpp"
#include "steps/step06_square/square.hpp"

#include "tests/documents/errata.hpp"

#include <array>
#include <cmath>

using namespace rt;

namespace {

/// PHY's B² − 4AC, and its coefficients.
struct Quadratic {
    Real a;
    Real b;
    Real c;
    [[nodiscard]] Real discriminant() const { return b * b - 4 * a * c; }
};

Quadratic situation_b(Vec3 center) {
    const Vec3 v(0, -3, 5);
    const Vec3 r = Vec3(3, 2, 0) - center;
    return {dot(v, v), 2 * dot(r, v), dot(r, r) - 9};
}

}  // namespace

TEST_CASE("erratum 9: the sphere's expansion misses terms (HAI)") {
    const Vec3 o(1, 2, 3);
    const Vec3 d(0, 0, 2);
    const Vec3 c(4, 0, 1);
    const Real t = 3;
    const Real whole = dot(o + t * d - c, o + t * d - c);
    const Real printed = dot(o, o) + t * dot(o, d) - dot(o, c) + t * dot(d, o) + t * t * dot(d, d) -
                         t * dot(d, c) + dot(c, c);
    const Real last_line = t * t * dot(d, d) + t * 2 * dot(d, o - c) + dot(o - c, o - c);
    CHECK(whole == 77);
    CHECK(printed == 90);  // even with D·V read as D·D
    CHECK(last_line == whole);
}

TEST_CASE("erratum 10: PC stands where CP is meant (HAI)") {
    const Vec3 corner(1, 1, 0);
    const Vec3 u(3, 0, 0);
    const Vec3 p = corner + u;
    CHECK(dot(corner - p, u) / dot(u, u) == -1);  // printed
    CHECK(dot(p - corner, u) / dot(u, u) == 1);
    const Square square{.center = corner + Vec3(Real(1.5), Real(1.5), 0), .basis = {}, .side = 3};
    CHECK(gives("square_uv at C + U", square_uv(square, p), Vec2(1, 0)));
}

TEST_CASE("erratum 18: situation B is solved with another center than the given one (PHY)") {
    const Quadratic given = situation_b({1, 0, -3});
    CHECK(std::array{given.a, given.b, given.c} == std::array<Real, 3>{34, 18, 8});
    CHECK(given.discriminant() == -764);
    const Quadratic worked = situation_b({1, -3, 0});
    CHECK(std::array{worked.a, worked.b, worked.c} == std::array<Real, 3>{34, -30, 20});
    CHECK(worked.discriminant() == -1820);
}

TEST_CASE("erratum 19: a unit v is required, and others are used (PHY)") {
    const Vec3 v(-1, 2, -3);
    CHECK(dot(v, v) == 14);
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    const Vec3 origin(2, -3, 1);
    CHECK(hits(Ray{.origin = origin, .direction = v}, plane, Real(8) / 15));
    // With the unit v that it requires, t is ‖v‖ times as large, and no longer its 0.5333.
    const Real size = std::sqrt(Real(14));
    CHECK(hits(Ray{.origin = origin, .direction = v / size}, plane, size * 8 / 15));
}

TEST_CASE("erratum 20: vectors and their coefficients are exchanged (HAI)") {
    // A = u (A·U / U·U) + v (A·V / V·V) is true with the vectors U and V outside the brackets.
    const Vec3 u(3, 0, 0);
    const Vec3 v(0, 2, 0);
    const Vec3 a(6, 8, 0);
    const Real along_u = dot(a, u) / dot(u, u);
    const Real along_v = dot(a, v) / dot(v, v);
    CHECK(gives("U (A·U / U·U) + V (A·V / V·V)", u * along_u + v * along_v, a));
    // With u and v the coordinates, as its next line has them, it is a number: 2 · 2 + 4 · 4.
    CHECK(along_u * along_u + along_v * along_v == 20);
}
