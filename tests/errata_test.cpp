// Where the documents are wrong (docs/errata.md): what is printed, worked out in numbers, fails,
// and what holds, holds. The numbers are small and whole, so that both are exact.
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/kit/verdict.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

const Sphere unit_sphere{.center = {0, 0, 0}, .radius = 1};
const Ray five_before{.origin = {0, 0, 5}, .direction = {0, 0, -1}};

/// PHY's B² − 4AC, and what it is made of.
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

/// CR §3.1's terms for a light along `light`, a normal and an eye along `eye`, all unit vectors.
struct Phong {
    Real diffuse;
    Real specular;
};

Phong printed_phong(Vec3 light, Vec3 normal, Vec3 eye, int shininess) {
    const Vec3 reflected = 2 * dot(light, normal) * normal - light;
    return {std::max(dot(light, normal), Real(0)),
            std::pow(std::max(dot(reflected, eye), Real(0)), Real(shininess))};
}

}  // namespace

TEST_CASE("erratum 1: MRT §3 subtracts r² in the discriminant") {
    const Vec3 to_center = unit_sphere.center - five_before.origin;
    const Real along = dot(five_before.direction, to_center);
    const Real printed = 4 * (along * along - dot(to_center, to_center) - 1);
    const Real right = 4 * (along * along - dot(to_center, to_center) + 1);
    CHECK(printed == -4);
    CHECK(right == 4);
    CHECK(hits(five_before, unit_sphere, 4));
}

TEST_CASE("erratum 2: MRT §3 drops ‖d‖² before t²") {
    const Ray ray{.origin = {0, 9, -15}, .direction = {0, -3, 5}};
    const Real b = 2 * dot(ray.direction, ray.origin);
    const Real c = dot(ray.origin, ray.origin) - 1;
    CHECK(dot(ray.direction, ray.direction) == 34);
    const Real t = 3 - 1 / std::sqrt(Real(34));  // one before the centre, which is 3 d away
    CHECK(std::abs(34 * t * t + b * t + c) < Real(0.001));
    CHECK(std::abs(t * t + b * t + c) > 250);  // as printed, that t is no root
    CHECK(hits(ray, unit_sphere, t));
}

TEST_CASE("erratum 3: MRT §2's X has not unit length") {
    const Vec3 z(0, std::sqrt(Real(0.75)), Real(0.5));  // pitched by 60°
    const Vec3 printed = cross(Vec3(0, 1, 0), z);
    CHECK(close(length(printed), Real(0.5)));
    CHECK(close(length(basis_around(z).x), 1));
}

TEST_CASE("erratum 4: MRT §8's cone is as wide as the root of r/h") {
    const Real r = 1;
    const Real h = 2;
    CHECK(close(std::sqrt(r / h * h * h), std::sqrt(Real(2))));  // printed, at z = h: 1.414
    CHECK(close(std::sqrt(r / h * r / h * h * h), r));
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = r, .height = h};
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, cone, 4));
    CHECK(misses(Ray{.origin = {Real(1.25), 2, 5}, .direction = {0, 0, -1}}, cone));
}

TEST_CASE("erratum 5: with strict inequalities the diagonal of a quad is a crack") {
    const Triangle lower{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Triangle upper{.a = {4, 4, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}};
    const Vec3 middle(2, 2, 0);
    for (const auto& [a, b, c] : {lower, upper}) {
        const Real side = dot(cross(c - b, middle - b), cross(c - b, a - b));
        CHECK(side == 0);  // MRT §5 asks for more than 0: neither triangle has the point
    }
    const Ray ray{.origin = {2, 2, 1}, .direction = {0, 0, -1}};
    CHECK(hits(ray, lower, 1));
    CHECK(hits(ray, upper, 1));
}

TEST_CASE("erratum 6: MRT §7 and §8 divide by a, which can be 0") {
    const Vec3 along_axis(0, 0, 1);
    CHECK(along_axis.x * along_axis.x + along_axis.y * along_axis.y == 0);  // §7's a
    const Vec3 along_side(1, 0, 1);                                         // of a cone with r = h
    CHECK(along_side.x * along_side.x + along_side.y * along_side.y - along_side.z * along_side.z ==
          0);  // §8's a
    const Cylinder tube{.center = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 2};
    CHECK(misses(Ray{.origin = {0, 0, -5}, .direction = along_axis}, tube));
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 4, .height = 4};
    CHECK(hits(Ray{.origin = {-4, 0, 0}, .direction = along_side}, cone, 2));  // −c / b
}

TEST_CASE("erratum 7: M1 gives a the area beside it") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    // At p = a the triangle opposite to a is everything, the one opposite to b nothing.
    const Real area_opposite_a = length(cross(triangle.c - triangle.b, triangle.a - triangle.b));
    const Real area_opposite_b = length(cross(triangle.a - triangle.c, triangle.a - triangle.c));
    const Real area = length(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    CHECK(area_opposite_b / area == 0);  // printed: α = A_b / A, which makes α a + β b + γ c = b
    CHECK(close(area_opposite_a / area, 1));
    CHECK(gives("the weights at a", barycentric(triangle, triangle.a), Vec3(1, 0, 0)));
}

TEST_CASE("erratum 8: M1's box test hits a box behind the camera") {
    // The box of side 2 around (0, 0, 5), a ray from 0 along −z: z's interval is −6 to −4, and x's
    // and y's are unbounded.
    const Real t_min = std::max({-infinity, -infinity, Real(-6)});
    const Real t_max = std::min({infinity, infinity, Real(-4)});
    CHECK(t_min < t_max);    // printed: a hit
    CHECK_FALSE(t_max > 0);  // what it also needs
}

TEST_CASE("erratum 9: HAI's expansion of the sphere misses terms") {
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

TEST_CASE("erratum 10: HAI takes PC where CP is meant") {
    const Vec3 corner(1, 1, 0);
    const Vec3 u(3, 0, 0);
    const Vec3 p = corner + u;
    CHECK(dot(corner - p, u) / dot(u, u) == -1);  // printed
    CHECK(dot(p - corner, u) / dot(u, u) == 1);
    const Square square{.center = corner + Vec3(Real(1.5), Real(1.5), 0), .basis = {}, .side = 3};
    CHECK(gives("square_uv at C + U", square_uv(square, p), Vec2(1, 0)));
}

TEST_CASE("erratum 11: CR's equations (2) and (3) reverse the sign of t") {
    const Vec3 o(2, -3, 1);
    const Vec3 d(-1, 2, -3);
    const Vec3 a(-2, 2, 2);
    const Vec3 n(Real(0.6), 0, Real(0.8));
    CHECK(close(dot(o - a, n) / dot(d, n), Real(-8) / 15));  // printed: −0.5333
    CHECK(close(dot(a - o, n) / dot(d, n), Real(8) / 15));
    CHECK(hits(Ray{.origin = o, .direction = d}, Plane{.point = a, .normal = n}, Real(8) / 15));
}

TEST_CASE("erratum 12: CR §2.2 hits a sphere behind the ray") {
    const Real t1 = -6;  // the roots of the unit sphere, five behind
    const Real t2 = -4;
    const bool takes_first = t1 > 0 && (t1 < t2 || t2 < 0);
    CHECK_FALSE(takes_first);  // so its listing takes the other branch, and is hit at t2
    CHECK(t2 < 0);
    CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, 1}}, unit_sphere));
}

TEST_CASE("erratum 13: CR §2.1 drops what is nearer than 4.9") {
    const Real t = 4;
    CHECK_FALSE(t > Real(4.9));  // printed: not kept
    CHECK(hits(five_before, unit_sphere, t));
}

TEST_CASE("erratum 14: CR §3.1 keeps the specular term on the side away from the light") {
    // The light is behind the surface, the eye before it.
    const Vec3 normal(0, 0, 1);
    const Vec3 light(Real(0.8), 0, Real(-0.6));
    const Vec3 eye(Real(-0.8), 0, Real(0.6));
    const Phong printed_terms = printed_phong(light, normal, eye, 1);
    CHECK(printed_terms.diffuse == 0);
    CHECK(close(printed_terms.specular, Real(0.28)));  // a highlight where no light comes
    // Ambient added once a light: two lights make twice the ambient light.
    const Real ambient = Real(0.25);
    Real printed = 0;
    for (int i = 0; i < 2; ++i) printed += ambient + printed_terms.diffuse;
    CHECK(printed == 2 * ambient);
}

TEST_CASE("erratum 15: CR §3.2 makes a point in shadow black") {
    const Real ambient = Real(0.25);
    const Real diffuse = 1;
    const auto printed = [&](bool blocked) { return blocked ? 0 : ambient + diffuse; };
    const auto right = [&](bool blocked) { return ambient + (blocked ? 0 : diffuse); };
    CHECK(printed(true) == 0);
    CHECK(right(true) == ambient);
    CHECK(printed(false) == right(false));
}

TEST_CASE("erratum 16: CR §3.3 samples beside the light, stops at 0.9, forgets the first light") {
    // rand() / (RAND_MAX / radius) is between 0 and radius: its mean is radius / 2, not 0.
    const Real radius = 2;
    const Real mean_of_printed = (0 + radius) / 2;
    CHECK(mean_of_printed == 1);
    // An occluder 3 along a unit direction, a light at 5: between them, and beyond 0.9.
    const Real occluder = 3;
    CHECK_FALSE(occluder < Real(0.9));
    CHECK(occluder < 5);
    // color = … in a loop over two lights of 1 and 2.
    Real printed = 0;
    Real right = 0;
    for (const Real light : {Real(1), Real(2)}) {
        printed = light;
        right += light;
    }
    CHECK(printed == 2);
    CHECK(right == 3);
}

TEST_CASE("erratum 17: CR §4.1 multiplies the point by the weights, and its areas have no sign") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Vec3 p(1, 2, 0);
    const Vec3 w = barycentric(triangle, p);
    CHECK(gives("P.x w0, P.y w1, P.z w2", p * w, Vec3(Real(0.25), Real(0.5), 0)));  // printed
    CHECK(gives("w0 a + w1 b + w2 c", w.x * triangle.a + w.y * triangle.b + w.z * triangle.c, p));
    // Outside, unsigned areas sum to more than 1: that they sum to 1 must be asked.
    const Vec3 outside = abs(barycentric(triangle, {4, 4, 0}));
    CHECK(close(outside.x + outside.y + outside.z, 3));
}

TEST_CASE("erratum 18: PHY's situation B is worked with another centre than it gives") {
    const Quadratic given = situation_b({1, 0, -3});
    CHECK(std::array{given.a, given.b, given.c} == std::array<Real, 3>{34, 18, 8});
    CHECK(given.discriminant() == -764);
    const Quadratic worked = situation_b({1, -3, 0});
    CHECK(std::array{worked.a, worked.b, worked.c} == std::array<Real, 3>{34, -30, 20});
    CHECK(worked.discriminant() == -1820);
}

TEST_CASE("erratum 19: PHY asks for a unit v and uses others, for which its formulas hold") {
    const Vec3 v(-1, 2, -3);
    CHECK(dot(v, v) == 14);
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    const Vec3 origin(2, -3, 1);
    CHECK(hits(Ray{.origin = origin, .direction = v}, plane, Real(8) / 15));
    // With the unit v that it asks for, t is ‖v‖ times as large, and no longer its 0.5333.
    const Real size = std::sqrt(Real(14));
    CHECK(hits(Ray{.origin = origin, .direction = v / size}, plane, size * 8 / 15));
}

TEST_CASE("erratum 20: HAI's decomposition exchanges coefficients and vectors") {
    // A = u (A·U / U·U) + v (A·V / V·V) holds with the vectors U and V outside the brackets.
    const Vec3 u(3, 0, 0);
    const Vec3 v(0, 2, 0);
    const Vec3 a(6, 8, 0);
    const Real along_u = dot(a, u) / dot(u, u);
    const Real along_v = dot(a, v) / dot(v, v);
    CHECK(gives("U (A·U / U·U) + V (A·V / V·V)", u * along_u + v * along_v, a));
    // With u and v the coordinates, as its next line has them, it is a number: 2 · 2 + 4 · 4.
    CHECK(along_u * along_u + along_v * along_v == 20);
}

TEST_CASE("erratum 21: CR §2.3 says scalar products of the normal and vectors in the plane") {
    const Vec3 normal(0, 0, 1);
    const Vec3 inside(1, 1, 0);
    const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 0),
                                         Vec3(0, 2, 0)};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 to_point = inside - corners[i];
        CHECK(dot(normal, to_point) == 0);  // printed: "greater than 0"
        CHECK(dot(normal, cross(corners[(i + 1) % 4] - corners[i], to_point)) > 0);  // its code
    }
}
