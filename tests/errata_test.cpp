// Where the documents are wrong (docs/errata.md): what is printed, worked out in numbers, fails,
// and what holds, holds. The numbers are small and whole, so that both are exact.
#include "steps/step01_ray_generation/ray_generation.hpp"
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

TEST_CASE("erratum 1: r² is subtracted in the discriminant (MRT §3)") {
    const Vec3 to_center = unit_sphere.center - five_before.origin;
    const Real along = dot(five_before.direction, to_center);
    const Real printed = 4 * (along * along - dot(to_center, to_center) - 1);
    const Real right = 4 * (along * along - dot(to_center, to_center) + 1);
    CHECK(printed == -4);
    CHECK(right == 4);
    CHECK(hits(five_before, unit_sphere, 4));
}

TEST_CASE("erratum 2: ‖d‖² is dropped before t² (MRT §3)") {
    const Ray ray{.origin = {0, 9, -15}, .direction = {0, -3, 5}};
    const Real b = 2 * dot(ray.direction, ray.origin);
    const Real c = dot(ray.origin, ray.origin) - 1;
    CHECK(dot(ray.direction, ray.direction) == 34);
    const Real t = 3 - 1 / std::sqrt(Real(34));  // one before the centre, which is 3 d away
    CHECK(std::abs(34 * t * t + b * t + c) < Real(0.001));
    CHECK(std::abs(t * t + b * t + c) > 250);  // as printed, that t is no root
    CHECK(hits(ray, unit_sphere, t));
}

TEST_CASE("erratum 3: X has not unit length (MRT §2)") {
    const Vec3 z(0, std::sqrt(Real(0.75)), Real(0.5));  // pitched by 60°
    const Vec3 printed = cross(Vec3(0, 1, 0), z);
    CHECK(close(length(printed), Real(0.5)));
    CHECK(close(length(basis_around(z).x), 1));
}

TEST_CASE("erratum 4: the cone is as wide as the root of r/h (MRT §8)") {
    const Real r = 1;
    const Real h = 2;
    CHECK(close(std::sqrt(r / h * h * h), std::sqrt(Real(2))));  // printed, at z = h: 1.414
    CHECK(close(std::sqrt(r / h * r / h * h * h), r));
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = r, .height = h};
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, cone, 4));
    CHECK(misses(Ray{.origin = {Real(1.25), 2, 5}, .direction = {0, 0, -1}}, cone));
}

TEST_CASE(
    "erratum 5: with strict inequalities a quad's diagonal is a crack (MRT §5–6, CR §2.3, §4.1)") {
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

TEST_CASE("erratum 6: a is divided by, and can be 0 (MRT §7–8)") {
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

TEST_CASE("erratum 7: a corner gets the area beside it (M1)") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    // At p = a the triangle opposite to a is everything, the one opposite to b nothing.
    const Real area_opposite_a = length(cross(triangle.c - triangle.b, triangle.a - triangle.b));
    const Real area_opposite_b = length(cross(triangle.a - triangle.c, triangle.a - triangle.c));
    const Real area = length(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    CHECK(area_opposite_b / area == 0);  // printed: α = A_b / A, which makes α a + β b + γ c = b
    CHECK(close(area_opposite_a / area, 1));
    CHECK(gives("the weights at a", barycentric(triangle, triangle.a), Vec3(1, 0, 0)));
}

TEST_CASE("erratum 8: a box behind the camera is hit (M1)") {
    // The box of side 2 around (0, 0, 5), and a ray from 0 along −z.
    const Vec3 o(0, 0, 0);
    const Vec3 d(0, 0, -1);
    Real t_min = -infinity;
    Real t_max = infinity;
    for (int i = 0; i < 3; ++i) {
        const Real middle = i == 2 ? 5 : 0;
        const auto [near, far] =
            std::minmax({(middle - 1 - o[i]) / d[i], (middle + 1 - o[i]) / d[i]});
        t_min = std::max(t_min, near);
        t_max = std::min(t_max, far);
    }
    CHECK(t_min == -6);
    CHECK(t_max == -4);
    CHECK(t_min < t_max);    // printed: a hit
    CHECK_FALSE(t_max > 0);  // what is needed as well
}

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

TEST_CASE("erratum 11: the sign of t is reversed (CR eq. 2–3)") {
    const Vec3 o(2, -3, 1);
    const Vec3 d(-1, 2, -3);
    const Vec3 a(-2, 2, 2);
    const Vec3 n(Real(0.6), 0, Real(0.8));
    CHECK(close(dot(o - a, n) / dot(d, n), Real(-8) / 15));  // printed: −0.5333
    CHECK(close(dot(a - o, n) / dot(d, n), Real(8) / 15));
    CHECK(hits(Ray{.origin = o, .direction = d}, Plane{.point = a, .normal = n}, Real(8) / 15));
}

TEST_CASE("erratum 12: a sphere behind the ray is hit (CR §2.2)") {
    const auto printed = [](Real t1, Real t2) { return t1 > 0 && (t1 < t2 || t2 < 0) ? t1 : t2; };
    CHECK(printed(4, 6) == 4);     // five ahead: right
    CHECK(printed(-1, 1) == 1);    // inside: right
    CHECK(printed(-6, -4) == -4);  // five behind: a hit that is none
    CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, 1}}, unit_sphere));
}

TEST_CASE("erratum 13: what is nearer than 4.9 is dropped (CR §2.1)") {
    // The nearest of two hits, four and six ahead.
    const auto nearest = [](Real more_than) {
        Real t = infinity;
        for (const Real hit : {Real(4), Real(6)})
            if (hit < t && hit > more_than) t = hit;
        return t;
    };
    CHECK(nearest(Real(4.9)) == 6);  // printed: one looks through the nearer
    CHECK(nearest(0) == 4);
    CHECK(hits(five_before, unit_sphere, 4));
}

TEST_CASE(
    "erratum 14: a highlight where no light comes, and ambient light once a light (CR §3.1)") {
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

TEST_CASE("erratum 15: a point in shadow is black (CR §3.2)") {
    const Real ambient = Real(0.25);
    const Real direct = Real(0.5);  // diffuse and specular
    const auto printed = [&](bool blocked) { return blocked ? 0 : ambient + direct; };
    const auto right = [&](bool blocked) { return ambient + (blocked ? 0 : direct); };
    CHECK(printed(false) == right(false));
    CHECK(printed(true) == 0);
    CHECK(right(true) == ambient);
}

TEST_CASE("erratum 16: samples beside the light, occluders to 0.9, the last light only (CR §3.3)") {
    // A light of radius 2 four above the ground, and half-way a strip |x| < 1, endless along z.
    // Under a strip in the middle the light is as free on the right as on the left.
    const Real radius = 2;
    constexpr int samples = 16;
    const auto free_share = [&](Real x, Real from, Real to) {
        int free = 0;
        for (int i = 0; i < samples; ++i) {
            const Real light = from + (to - from) * (Real(i) + Real(0.5)) / samples;
            if (std::abs((x + light) / 2) >= 1) ++free;  // where the ray crosses the strip's height
        }
        return Real(free) / samples;
    };
    CHECK(free_share(Real(1.5), 0, radius) == Real(0.75));  // printed: rand() from 0 to radius
    CHECK(free_share(Real(-1.5), 0, radius) == 0);
    CHECK(free_share(Real(1.5), -radius, radius) == Real(0.375));
    CHECK(free_share(Real(-1.5), -radius, radius) == Real(0.375));
    // An occluder three along a unit direction, a light at five: between them, and beyond 0.9.
    const Real occluder = 3;
    CHECK_FALSE(occluder < Real(0.9));
    CHECK(occluder < 5);
    // "color =" in the loop over two lights, of 0.5 and 0.25; and "color *= shadow" takes the
    // ambient light, 0.125, along.
    const Real ambient = Real(0.125);
    const Real blocked = 0;
    Real printed = 0;
    Real right = ambient;
    for (const Real light : {Real(0.5), Real(0.25)}) {
        printed = ambient + light;
        right += light;
    }
    CHECK(printed == Real(0.375));
    CHECK(right == Real(0.875));
    CHECK(printed * blocked == 0);  // black, where ambient light is left
}

TEST_CASE("erratum 17: the point is multiplied by its weights, and areas have no sign (CR §4.1)") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Vec3 p(1, 2, 0);
    const Vec3 w = barycentric(triangle, p);
    CHECK(gives("P.x w0, P.y w1, P.z w2", p * w, Vec3(Real(0.25), Real(0.5), 0)));  // printed
    CHECK(gives("w0 a + w1 b + w2 c", w.x * triangle.a + w.y * triangle.b + w.z * triangle.c, p));
    // Outside, unsigned areas sum to more than 1: that they sum to 1 must be asked.
    const Vec3 outside = abs(barycentric(triangle, {4, 4, 0}));
    CHECK(close(outside.x + outside.y + outside.z, 3));
}

TEST_CASE("erratum 18: situation B is worked with another centre than it gives (PHY)") {
    const Quadratic given = situation_b({1, 0, -3});
    CHECK(std::array{given.a, given.b, given.c} == std::array<Real, 3>{34, 18, 8});
    CHECK(given.discriminant() == -764);
    const Quadratic worked = situation_b({1, -3, 0});
    CHECK(std::array{worked.a, worked.b, worked.c} == std::array<Real, 3>{34, -30, 20});
    CHECK(worked.discriminant() == -1820);
}

TEST_CASE("erratum 19: a unit v is asked for, and others are used (PHY)") {
    const Vec3 v(-1, 2, -3);
    CHECK(dot(v, v) == 14);
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    const Vec3 origin(2, -3, 1);
    CHECK(hits(Ray{.origin = origin, .direction = v}, plane, Real(8) / 15));
    // With the unit v that it asks for, t is ‖v‖ times as large, and no longer its 0.5333.
    const Real size = std::sqrt(Real(14));
    CHECK(hits(Ray{.origin = origin, .direction = v / size}, plane, size * 8 / 15));
}

TEST_CASE("erratum 20: vectors and their coefficients are exchanged (HAI)") {
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

TEST_CASE("erratum 21: scalar products of the normal with vectors in its plane (CR §2.3)") {
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

TEST_CASE("erratum 22: ⟨d, n⟩ is divided by, and can be 0 (MRT §4, M1, PHY, CR eq. 3)") {
    // One above the ground and along it.
    const Ray ray{.origin = {0, 1, 0}, .direction = {1, 0, 0}};
    const Plane below{.point = {0, 0, 0}, .normal = {0, -1, 0}};
    const Real slope = dot(ray.direction, below.normal);
    CHECK(std::abs(slope) == 0);
    const Real t = dot(below.point - ray.origin, below.normal) / std::abs(slope);
    CHECK(t > 0);  // printed: "t positive" is all that is asked, and ∞ is
    CHECK(t == infinity);
    CHECK(misses(ray, below));
    // In the plane itself it is 0 / 0.
    CHECK(std::isnan(dot(below.point - below.point, below.normal) / slope));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}}, below));
}

TEST_CASE("erratum 23: a ray along the square is inside it (CR §2.3)") {
    // Its listing asks whether four answers are the same, and not which: four times "no" will do.
    const Vec3 normal(0, 0, 1);
    const std::array<Vec3, 4> corners = {Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(2, 2, 1),
                                         Vec3(0, 2, 1)};
    const auto printed = [&](Vec3 p) {
        std::array<bool, 4> answers{};
        for (std::size_t i = 0; i < 4; ++i)
            answers[i] = dot(cross(corners[(i + 1) % 4] - corners[i], p - corners[i]), normal) > 0;
        return std::ranges::all_of(answers, [&](bool answer) { return answer == answers[0]; });
    };
    CHECK(printed({1, 1, 1}));
    CHECK_FALSE(printed({3, 1, 1}));
    const Ray along{.origin = {0, 0, 0}, .direction = {1, 0, 0}};
    const Real t = dot(corners[0] - along.origin, normal) / dot(along.direction, normal);
    CHECK(t == infinity);          // more than 0,
    CHECK(printed(at(along, t)));  // and at (∞, NaN, NaN) no answer is yes: a hit
    CHECK(misses(along, Square{.center = {1, 1, 1}, .basis = {}, .side = 2}));
}

TEST_CASE("erratum 24: either of the two t will do, negative or not the smallest (MRT §7–8)") {
    const Cylinder tube{.center = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 2};
    // x² + y² = 1 and |z| ≤ 1, which is all that is asked.
    const auto printed = [](Vec3 p) { return p.x * p.x + p.y * p.y == 1 && std::abs(p.z) <= 1; };
    const Ray inside{.origin = {0, 0, 0}, .direction = {1, 0, 0}};
    CHECK(printed(at(inside, -1)));
    CHECK(printed(at(inside, 1)));
    CHECK(hits(inside, tube, 1));
    const Ray outside{.origin = {-5, 0, 0}, .direction = {1, 0, 0}};
    CHECK(printed(at(outside, 4)));
    CHECK(printed(at(outside, 6)));
    CHECK(hits(outside, tube, 4));
}

TEST_CASE("erratum 25: with Z as in its §2 the cone opens against its axis (MRT §8)") {
    const Vec3 axis(0, 1, 0);
    const Vec3 p(1, 2, 0);       // on the rim of a cone from 0 with r = 1, h = 2
    CHECK(dot(p, -axis) == -2);  // §2: Z = −c, so that not 0 ≤ z ≤ h
    CHECK(dot(p, axis) == 2);    // Z is the axis itself
    const Cone cone{.apex = {0, 0, 0}, .axis = axis, .radius = 1, .height = 2};
    CHECK(hits(Ray{.origin = {5, 1, 0}, .direction = {-1, 0, 0}}, cone, Real(4.5)));
    CHECK(misses(Ray{.origin = {5, -1, 0}, .direction = {-1, 0, 0}}, cone));
}

TEST_CASE("erratum 26: the end point is not divided by its w, nor a pixel's centre (M1)") {
    // A camera at (0, 6, 0) that looks along −z with a field of 90°, near plane 1, far plane 3.
    Mat4 view(1);
    view[3] = {0, -6, 0, 1};
    Mat4 projection(0);
    projection[0][0] = 1;
    projection[1][1] = 1;
    projection[2] = {0, 0, -2, -1};
    projection[3] = {0, 0, -3, 0};
    const Vec4 end(1, 2, -1, Real(1) / 3);  // what the inverse of P V makes of (1, 0, 1, 1)
    const Vec4 there = projection * view * end;
    CHECK(close(Vec3(there), Vec3(1, 0, 1)));
    CHECK(close(there.w, 1));
    // Divided by w it is the right end of the far plane; as it stands it is another point.
    CHECK(close(Vec3(end) / end.w, Vec3(3, 6, -3)));
    const Vec4 printed = projection * view * Vec4(Vec3(end), 1);
    CHECK(close(Vec3(printed) / printed.w, Vec3(1, -4, -1)));
    // x = 0 is the left edge of the image, −1; the centre of the first of four pixels is not.
    CHECK(2 * Real(0) / 4 - 1 == -1);
    CHECK(gives("the first of four pixels", pixel_on_screen({}, {.width = 4, .height = 4}, pi / 2),
                Vec2(Real(-0.75), Real(0.75))));
}

TEST_CASE("erratum 27: the torch shines less than not at all on what faces away (M1)") {
    const Vec3 normal(0, 0, -2);
    const Vec3 to_eye(0, 0, 3);
    CHECK(dot(normal, to_eye) / (length(normal) * length(to_eye)) == -1);  // printed: cos θ
    CHECK(torch({0, 0, 0}, normal, to_eye) == 0);
}

TEST_CASE("erratum 28: the mesh is ten thousand times too small (CR §4.2)") {
    const Triangle triangle{.a = {-1, -1, 0}, .b = {1, -1, 0}, .c = {0, 1, 0}};
    const Real scale = Real(0.0001);  // triangleScaling, after the mesh was scaled to unit size
    const Triangle printed{
        .a = scale * triangle.a, .b = scale * triangle.b, .c = scale * triangle.c};
    const Ray ray{.origin = {0, Real(-0.5), 5}, .direction = {0, 0, -1}};
    CHECK(hits(ray, triangle, 5));
    CHECK(misses(ray, printed));
}

TEST_CASE("erratum 29: n must have unit length (CR eq. 4)") {
    const Vec3 d(1, -1, 0);
    const Vec3 n(0, 2, 0);
    CHECK(gives("R as printed", d - 2 * dot(d, n) * n, Vec3(1, 7, 0)));
    CHECK(gives("R", d - 2 * dot(d, n) / dot(n, n) * n, Vec3(1, 1, 0)));
}

TEST_CASE("erratum 30: one bounce is none (CR §2.1, §5.1)") {
    // A mirror before a wall of brightness 1: what the camera sees, with so many bounces left.
    const auto wall_in_mirror = [](int bounces, bool counts_the_first_ray) {
        int rays = counts_the_first_ray ? bounces : bounces + 1;
        if (rays-- == 0) return 0;  // the ray that meets the mirror
        if (rays-- == 0) return 0;  // the one that it reflects
        return 1;
    };
    CHECK(wall_in_mirror(1, true) == 0);  // printed: rayTrace passes 1, and the mirror is black
    CHECK(wall_in_mirror(2, true) == 1);
    CHECK(wall_in_mirror(1, false) == 1);
}

TEST_CASE("erratum 31: a constant distance is too large for a small scene (CR §3.2, §4.2, §5.1)") {
    // The same scene, ten thousand times smaller: an occluder 3 away, a light 5 away.
    for (const Real scale : {Real(1), Real(0.0001)}) {
        const Real occluder = 3 * scale;
        const Real light = 5 * scale;
        CHECK((occluder > Real(0.001) && occluder < light) == (scale == 1));  // printed
        CHECK((occluder > 0 && occluder < light));
    }
}
