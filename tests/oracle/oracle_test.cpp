// The oracle against cases worked by hand, in whole numbers and fractions.
#include "tests/oracle/camera.hpp"
#include "tests/oracle/distances.hpp"
#include "tests/oracle/shapes.hpp"

#include "tests/kit/catch.hpp"

#include <cmath>
#include <limits>

using namespace rt::oracle;

namespace {

/// Ninety of the hundred digits, relative to 1 at least.
bool same(const Number& got, const Number& expected) {
    return abs(got - expected) <= Number("1e-90") * (1 + abs(expected));
}

bool same(const NumberVector& got, const NumberVector& expected) {
    return same(got.x, expected.x) && same(got.y, expected.y) && same(got.z, expected.z);
}

Number fraction(int numerator, int denominator) {
    return Number(numerator) / denominator;
}

template <class Shape>
bool hits(const Ray& ray, const Shape& shape, const Number& t, const Interval& interval = {}) {
    const auto got = intersect(ray, shape, interval);
    return got && same(got->value(), t);
}

template <class Shape>
bool misses(const Ray& ray, const Shape& shape, const Interval& interval = {}) {
    return !intersect(ray, shape, interval);
}

const double tiny = std::ldexp(1.0, -1074);
const double huge = std::numeric_limits<double>::max();

}  // namespace

TEST_CASE("sums and products are exact, whatever the exponents") {
    CHECK(Exact(0.1) != Exact(0.1F));
    CHECK(Exact(3) * Exact(-0.5) == Exact(-1.5));
    CHECK((Exact(huge) + Exact(tiny) - Exact(huge)) == Exact(tiny));
    CHECK((squared(Exact(huge) + Exact(tiny)) - squared(Exact(huge))).sign() == 1);
    CHECK((Exact(0.0) + Exact(-0.0)).sign() == 0);
    CHECK((Exact(1) - Exact(1)).sign() == 0);
    CHECK(Exact(std::nextafter(1.0, 2)) > Exact(1));
    CHECK(same(Exact(0.625).number(), fraction(5, 8)));
    CHECK((Exact(tiny) * Exact(tiny)).number() == ldexp(Number(1), -2148));
}

TEST_CASE("a quadratic's roots are ordered, and their signs exact") {
    const auto by_thirds = quadratic_roots(3, -2, 1);  // (3 t − 1) (t − 1)
    REQUIRE(by_thirds.size() == 2);
    CHECK(same(by_thirds[0].value(), fraction(1, 3)));
    CHECK(same(by_thirds[1].value(), 1));
    CHECK(by_thirds[0].sign_of(-1, 3) == 0);
    CHECK(by_thirds[0].sign_of(-1.0 / 3, 1) > 0);  // a double's third is too small
    CHECK(by_thirds[1].sign_of(1, -2, 1) == 0);

    const auto reversed = quadratic_roots(-3, 2, -1);
    REQUIRE(reversed.size() == 2);
    CHECK(same(reversed[0].value(), fraction(1, 3)));

    const auto surds = quadratic_roots(1, 0, -2);
    REQUIRE(surds.size() == 2);
    CHECK(same(surds[1].value(), sqrt(Number(2))));
    CHECK(surds[1].sign_of(-2, 0, 1) == 0);
    CHECK(surds[1].sign_of(-1.4142135623730950488, 1) < 0);  // the double is too large
    CHECK(surds[0].sign_of(1.4142135623730950488, 1) > 0);

    // Far apart: the near root of t² − 2^101 t + 1 is 2^−101 and a little.
    const auto apart = quadratic_roots(1, -std::ldexp(1.0, 100), 1);
    REQUIRE(apart.size() == 2);
    CHECK(apart[0].sign_of(-std::ldexp(1.0, -101), 1) > 0);
    CHECK(abs(apart[0].value() * ldexp(Number(1), 101) - 1) < Number("1e-60"));

    CHECK(quadratic_roots(1, 0, 1).empty());
    CHECK(quadratic_roots(1, -1, 1).size() == 1);
    CHECK(quadratic_roots(0, 0, 1).empty());
    CHECK(quadratic_roots(0, 0, 0).empty());
    CHECK(same(quadratic_roots(0, 2, -1)[0].value(), fraction(1, 4)));
}

TEST_CASE("spheres (PHY, by hand)") {
    const Sphere ball{.center = {0, 0, -5}, .radius = 2};
    const Ray ray{.origin = {}, .direction = {0, 0, -3}};
    CHECK(hits(ray, ball, 1));
    CHECK(hits(ray, ball, fraction(7, 3), {.min = 1}));  // strictly inside
    CHECK(misses(ray, ball, {.min = 1, .max = Exact(2)}));
    CHECK(hits({.origin = {2, 0, 0}, .direction = {0, 0, -1}}, ball, 5));  // touches
    CHECK(misses({.origin = {2, tiny, 0}, .direction = {0, 0, -1}}, ball));
    CHECK(misses({.origin = {}, .direction = {0, 0, 1}}, ball));
    CHECK(misses({.origin = {}, .direction = {}}, ball));
    CHECK(same(normal(ball, {2, 1, -3}), {fraction(2, 3), fraction(1, 3), fraction(2, 3)}));
    CHECK(same(off_surface({2, 1, -3}, ball), 1));
    CHECK(same(gap({.origin = {3, 0, 0}, .direction = {0, 0, -1}}, {}, ball), 1));
}

TEST_CASE("planes (PHY's situation A, by hand)") {
    const Plane plane{.point = {1, 2, 3}, .normal = {2, -1, 2}};
    const Ray ray{.origin = {}, .direction = {1, 1, 1}};
    CHECK(hits(ray, plane, 2));  // (2 − 2 + 6) / 3
    CHECK(misses({.origin = {}, .direction = {1, 2, 0}}, plane));
    CHECK(misses({.origin = {}, .direction = {-1, -1, -1}}, plane));
    CHECK(same(normal(plane, {}), {fraction(2, 3), fraction(-1, 3), fraction(2, 3)}));
    CHECK(same(off_surface({}, plane), 2));
}

TEST_CASE("triangles (MRT §5, by hand)") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {3, 0, 0}, .c = {0, 3, 0}};
    const auto from = [](Exact x, Exact y) {
        return Ray{.origin = {x, y, 2}, .direction = {0, 0, -1}};
    };
    CHECK(hits(from(1, 1), triangle, 2));
    CHECK(hits(from(1.5, 1.5), triangle, 2));  // on an edge
    CHECK(hits(from(3, 0), triangle, 2));      // at a corner
    CHECK(misses(from(1.5, std::nextafter(1.5, 2)), triangle));
    CHECK(misses(from(1, -tiny), triangle));
    CHECK(misses({.origin = {1, 1, 0}, .direction = {1, 0, 0}}, triangle));
    CHECK(misses(from(1, 1), Triangle{.a = {0, 0, 0}, .b = {1, 1, 0}, .c = {2, 2, 0}}));
    CHECK(same(normal(triangle, {}), {0, 0, 1}));
    CHECK(same(normal(Triangle{triangle.a, triangle.c, triangle.b}, {}), {0, 0, -1}));
    CHECK(same(barycentric(triangle, {1, 0, 7}), {fraction(2, 3), fraction(1, 3), 0}));
    CHECK(
        same(barycentric(triangle, {-1, 2, 0}), {fraction(2, 3), fraction(-1, 3), fraction(2, 3)}));
    CHECK(same(gap(from(1, -0.25), {}, triangle), fraction(1, 4)));
    CHECK(same(gap(from(7, -3), {}, triangle), 5));
}

TEST_CASE("squares (MRT §6, by hand)") {
    const Square square{
        .center = {1, 0, 0}, .x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .side = 4};
    const auto from = [](Exact y, Exact z) {
        return Ray{.origin = {3, y, z}, .direction = {-2, 0, 0}};
    };
    CHECK(hits(from(2, -2), square, 1));  // a corner
    CHECK(misses(from(std::nextafter(2.0, 3), 0), square));
    CHECK(misses({.origin = {1, 0, 0}, .direction = {0, 1, 0}}, square));
    Square one_sided = square;
    one_sided.one_sided = true;
    CHECK(hits(from(0, 0), one_sided, 1));
    CHECK(misses({.origin = {0, 0, 0}, .direction = {1, 0, 0}}, one_sided));
    CHECK(same(square_uv(square, {1, 2, -1})[0], 1));
    CHECK(same(square_uv(square, {1, 2, -1})[1], fraction(1, 4)));
    CHECK(same(gap(from(3, 0), {}, square), 1));
}

TEST_CASE("cylinders (MRT §7, by hand)") {
    // The axis' length does not matter: it is a direction.
    const Cylinder tube{.center = {0, 1, 0}, .axis = {0, 3, 0}, .radius = 2, .height = 6};
    CHECK(hits({.origin = {5, 0, 0}, .direction = {-1, 0, 0}}, tube, 3));
    CHECK(hits({.origin = {5, 4, 0}, .direction = {-1, 0, 0}}, tube, 3));  // the rims belong to it
    CHECK(hits({.origin = {5, -2, 0}, .direction = {-1, 0, 0}}, tube, 3));
    CHECK(misses({.origin = {5, std::nextafter(4.0, 5), 0}, .direction = {-1, 0, 0}}, tube));
    CHECK(hits({.origin = {4, 7, 0}, .direction = {-1, -1, 0}}, tube, 6));  // in at the top
    CHECK(hits({.origin = {0, 0, 0}, .direction = {3, 0, 4}}, tube, fraction(2, 5)));
    CHECK(hits({.origin = {2, 0, 1}, .direction = {0, 0, -1}}, tube, 1));  // touches
    CHECK(misses({.origin = {0, 9, 0}, .direction = {0, -1, 0}}, tube));
    CHECK(misses({.origin = {2, 9, 0}, .direction = {0, -1, 0}}, tube));  // in the side
    CHECK(same(normal(tube, {3, 2, 4}), {fraction(3, 5), 0, fraction(4, 5)}));
    CHECK(same(off_surface({3, 9, 4}, tube), 3));
    CHECK(same(gap({}, {3, 8, 4}, tube), 5));
}

TEST_CASE("cones (MRT §8, by hand)") {
    const Cone cone{.apex = {0, 0, 1}, .axis = {0, 0, 2}, .radius = 3, .height = 4};
    CHECK(hits({.origin = {9, 0, 3}, .direction = {-1, 0, 0}}, cone, fraction(15, 2)));
    CHECK(hits({.origin = {9, 0, 5}, .direction = {-1, 0, 0}}, cone, 6));  // the rim belongs to it
    CHECK(misses({.origin = {9, 0, std::nextafter(5.0, 6)}, .direction = {-1, 0, 0}}, cone));
    CHECK(hits({.origin = {9, 0, 1}, .direction = {-1, 0, 0}}, cone, 9));  // the apex
    CHECK(misses({.origin = {9, 0, 0}, .direction = {-1, 0, 0}}, cone));   // the other nappe
    CHECK(hits({.origin = {0, 0, 3}, .direction = {0, 3, 4}}, cone, fraction(-1, 4), {.min = -1}));
    CHECK(misses({.origin = {0, 0, 1}, .direction = {3, 0, 4}}, cone));  // in the side
    CHECK(
        hits({.origin = {0, 1, 3}, .direction = {0, -3, 4}}, cone, fraction(-1, 12), {.min = -1}));
    CHECK(same(normal(cone, {0, 3, 5}), {0, fraction(4, 5), fraction(-3, 5)}));
    CHECK(same(normal(cone, {0, 0, 1}), {0, 0, -1}));
    CHECK(same(off_surface({0, 0, 6}, cone), 3));
    CHECK(same(gap({}, {0, 0, 0}, cone), 1));
    CHECK(same(gap({}, {0, 3, 7}, cone), 2));
}

TEST_CASE("color, torch and mirror (M1, CR §5.1, by hand)") {
    CHECK(same(color_from_normal({-2, 1, -2}), {fraction(2, 3), fraction(1, 3), fraction(2, 3)}));
    CHECK(same(torch({0, 0, 0}, {0, 5, 0}, {3, 4, 0}), fraction(4, 5)));
    CHECK(torch({0, 0, 0}, {0, -1, 0}, {3, 4, 0}) == 0);
    CHECK(torch({3, 4, 0}, {0, -1, 0}, {3, 4, 0}) == 0);
    CHECK(same(mirrored({1, -2, 3}, {0, 7, 0}), {1, 2, 3}));
    CHECK(same(mirrored({1, 0, 0}, {-1, 1, 0}), {0, 1, 0}));
}

TEST_CASE("boxes (M1, by hand)") {
    const ExactVector min{-1, -1, -1};
    const ExactVector max{1, 1, 1};
    const Ray ray{.origin = {-3, 1, 0}, .direction = {1, 0, 0}};
    CHECK(overlap(ray, min, max, {}));  // along a face
    CHECK_FALSE(
        overlap({.origin = {-3, 1 + Exact(tiny), 0}, .direction = {1, 0, 0}}, min, max, {}));
    CHECK(overlap(ray, min, max, {.min = 0, .max = Exact(2)}));
    CHECK_FALSE(overlap(ray, min, max, {.min = 0, .max = Exact(std::nextafter(2.0, 1))}));
    CHECK_FALSE(overlap(ray, min, max, {.min = std::nextafter(4.0, 5)}));
    CHECK(
        overlap({.origin = {-2, 0, 3}, .direction = {1, -1, -2}}, min, max, {}));  // at (-1, -1, 1)
    CHECK_FALSE(overlap({.origin = {-2, 0, 3}, .direction = {1, -1, Exact(-2) + Exact(tiny)}}, min,
                        max, {}));
    CHECK_FALSE(overlap({.origin = {3, 0, 0}, .direction = {1, 0, 0}}, min, max, {}));
    CHECK_FALSE(overlap(ray, max, min, {}));  // empty
}

TEST_CASE("rays through pixels (MRT §1, by hand)") {
    // tan of a double next to π/2 is not 1 to the last digit: the expected value is the tangent of
    // that double.
    const Number tangent =
        pixel_on_screen({.row = -1, .column = 0}, {.width = 1, .height = 1}, 2)[1] / 2;
    CHECK(abs(tangent - Number("1.5574077246549022305069748074583601730872507723815200")) <
          Number("1e-50"));
    const auto [x, y] = pixel_on_screen({.row = 1, .column = 0}, {.width = 4, .height = 2}, 2);
    CHECK(same(x, fraction(-3, 2) * tangent));
    CHECK(same(y, fraction(-1, 2) * tangent));
    CHECK(same(camera_ray({.row = 1, .column = 0}, {.width = 4, .height = 2}, 2).direction,
               {x, y, -1}));

    Matrix camera{};
    Matrix image{};
    for (std::size_t i = 0; i < 4; ++i) camera[i][i] = image[i][i] = 2;
    camera[0][3] = 6;
    image[3][3] = 3;
    const NumberRay ray = unprojected_ray({.row = 2, .column = 1}, camera, image);
    CHECK(same(ray.origin, {3, 0, 0}));
    CHECK(same(ray.direction, {-2, fraction(5, 3), fraction(2, 3)}));
}

TEST_CASE("bases (MRT §2, by hand)") {
    const auto [x, y, z] = orthonormal_basis({3, 0, 4});
    CHECK(same(x, {fraction(4, 5), 0, fraction(-3, 5)}));
    CHECK(same(y, {0, 1, 0}));
    CHECK(same(z, {fraction(3, 5), 0, fraction(4, 5)}));
    const auto tilted = orthonormal_basis({6, 2, 3});  // of length 7
    CHECK(same(tilted.z, {fraction(6, 7), fraction(2, 7), fraction(3, 7)}));
    CHECK(same(cross(tilted.z, tilted.x), tilted.y));
    for (const int up : {1, -1}) {
        const auto vertical = orthonormal_basis({0, up * Exact(tiny), 0});
        CHECK(same(vertical.x, {1, 0, 0}));
        CHECK(same(vertical.z, {0, up, 0}));
        CHECK(same(cross(vertical.z, vertical.x), vertical.y));
    }
    CHECK(same(camera_basis({0, 0, -9}).z, {0, 0, 1}));

    const Basis<Exact> turn{.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}};
    CHECK(same(number(rotated({1, 2, 3}, turn)), {3, 1, 2}));
    CHECK(same(number(seen({13, 11, 12}, turn, {10, 10, 10})), {1, 2, 3}));
}
