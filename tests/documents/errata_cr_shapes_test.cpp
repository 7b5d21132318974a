// Errata of CR about shapes (its §2, §4): see tests/documents/errata.hpp.
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"

#include "tests/documents/errata.hpp"

#include <algorithm>
#include <array>
#include <optional>

using namespace rt;

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
    CHECK(printed(-6, -4) == -4);  // five behind: reported as a hit
    CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, 1}}, unit_sphere));
}

TEST_CASE("erratum 13: hits closer than 4.9 are dropped (CR §2.1)") {
    // The nearest of two hits, four and six ahead.
    const auto nearest = [](Real more_than) {
        Real t = infinity;
        for (const Real hit : {Real(4), Real(6)})
            if (hit < t && hit > more_than) t = hit;
        return t;
    };
    CHECK(nearest(Real(4.9)) == 6);  // printed: the closer shape is missed
    CHECK(nearest(0) == 4);
    CHECK(hits(five_before, unit_sphere, 4));
}

TEST_CASE("erratum 17: the point is multiplied by its weights, and areas have no sign (CR §4.1)") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Vec3 p(1, 2, 0);
    const Vec3 w = barycentric(triangle, p);
    CHECK(gives("P.x w0, P.y w1, P.z w2", p * w, Vec3(Real(0.25), Real(0.5), 0)));  // printed
    CHECK(gives("w0 a + w1 b + w2 c", w.x * triangle.a + w.y * triangle.b + w.z * triangle.c, p));
    // Outside, unsigned areas sum to more than 1: the sum of 1 must be tested.
    const Vec3 outside = abs(barycentric(triangle, {4, 4, 0}));
    CHECK(close(outside.x + outside.y + outside.z, 3));
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

TEST_CASE("erratum 23: a ray along the square is inside it (CR §2.3)") {
    // The listing tests whether four answers are equal, not which answer it is: four times "no"
    // passes.
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
    CHECK(printed(at(along, t)));  // and at (∞, NaN, NaN) no answer is "yes": all equal, a hit
    CHECK(misses(along, Square{.center = {1, 1, 1}, .basis = {}, .side = 2}));
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

TEST_CASE("erratum 32: a hit is the only answer that is not returned (CR §4.1)") {
    // The paths of getIntersection: what each returns, or nothing where the function ends without a
    // return.
    const auto printed = [](bool parallel, Real t, bool inside) -> std::optional<bool> {
        if (parallel) return false;
        if (t < 0) return false;
        if (!inside) return false;
        return std::nullopt;  // after "result.intersectionExists = true"
    };
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Ray along{.origin = {1, 1, 0}, .direction = {1, 0, 0}};
    const Ray behind{.origin = {1, 1, -2}, .direction = {0, 0, -1}};
    const Ray beside{.origin = {3, 3, 2}, .direction = {0, 0, -1}};
    const Ray onto{.origin = {1, 1, 2}, .direction = {0, 0, -1}};
    for (const Ray& ray : {along, behind, beside, onto}) {
        const Vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const Real t = dot(triangle.a - ray.origin, n) / dot(ray.direction, n);
        const Vec3 w = barycentric(triangle, at(ray, t));
        const bool inside = w.x >= 0 && w.y >= 0 && w.z >= 0;
        const bool is_hit = intersect(ray, triangle, {}).has_value();
        CHECK(printed(dot(ray.direction, n) == 0, t, inside).has_value() == !is_hit);
    }
    CHECK(hits(onto, triangle, 2));
}
