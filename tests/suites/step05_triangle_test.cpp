// Stage 5 against MRT §5, M1 and CR §4.1.
#include "steps/step05_triangle/triangle.hpp"

#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

using namespace rt;

namespace {

/// Seen from above: a at the origin, b to the right, c upwards; its normal is (0, 0, 1).
const Triangle right_angled{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};

Ray down_at(Real x, Real y) {
    return {.origin = {x, y, 2}, .direction = {0, 0, -1}};
}

/// Weights of at least 0.1, so that rounding does not decide what is inside.
Vec3 inner_weights(Random& random) {
    const Vec3 w(random.between(1, 5), random.between(1, 5), random.between(1, 5));
    return w / (w.x + w.y + w.z);
}

/// Two sides of length 1 to 2 at an angle of 30° at least: not a sliver.
Triangle draw_triangle(Random& random) {
    const Basis basis = draw_basis(random);
    const Vec3 a = random.point(3);
    const Real angle = random.between(pi / 6, 5 * pi / 6);
    const Vec3 along = std::cos(angle) * basis.x + std::sin(angle) * basis.y;
    return {.a = a, .b = a + random.between(1, 2) * basis.x, .c = a + random.between(1, 2) * along};
}

Vec3 weighted(const Triangle& triangle, Vec3 w) {
    return w.x * triangle.a + w.y * triangle.b + w.z * triangle.c;
}

Sample<Triangle> draw(Random& random) {
    const Triangle triangle = draw_triangle(random);
    const Vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    return {.shape = triangle,
            .point = weighted(triangle, inner_weights(random)),
            .normal = n / std::sqrt(dot(n, n))};
}

/// In a plane across an axis, so that the box around it is flat, too.
Sample<Triangle> draw_across_an_axis(Random& random) {
    const auto [x, y, z] = random.axes();
    const Vec3 a = random.point(3);
    const Triangle triangle{
        .a = a, .b = a + random.between(1, 2) * x, .c = a + random.between(1, 2) * y};
    return {.shape = triangle, .point = weighted(triangle, inner_weights(random)), .normal = z};
}

/// As `draw_across_an_axis`, but a rounding off: no coordinate of the normal is 0, and points in
/// the plane can do without the coordinate along the axis alone.
Sample<Triangle> draw_almost_across_an_axis(Random& random) {
    const auto [x, y, z] = random.axes();
    const Vec3 a = random.between(-3, 3) * x;
    const Triangle triangle{.a = a,
                            .b = a + random.between(1, 2) * x + unit_roundoff * z,
                            .c = a + random.between(1, 2) * y + unit_roundoff * z};
    return {.shape = triangle, .point = weighted(triangle, inner_weights(random)), .normal = z};
}

/// A ray at a point of the plane whose weight of a random corner is this.
Aimed<Triangle> aimed_with_weight(Real weight, Random& random) {
    Sample<Triangle> sample = draw(random);
    const Real part = random.between(Real(0.2), Real(0.8)) * (1 - weight);
    Vec3 w(weight, part, 1 - weight - part);
    std::swap(w.x, w[random.below(3)]);
    sample.point = weighted(sample.shape, w);
    return aimed_from_outside(sample, random);
}

Past<Triangle> draw_past(Random& random) {
    const auto aimed = aimed_with_weight(-random.between(Real(0.1), 1), random);
    return {.ray = aimed.ray, .shape = aimed.shape};
}

/// A ray at right angles hits the point with these weights if none is negative, where nothing is
/// rounded: corners in eighths, two sides along axes and as long as powers of two.
Verdict hits_exactly_at(Vec3 weights, Random& random) {
    const auto [x, y, z] = random.axes();
    const Vec3 corner = random.point_in_eighths(3);
    const Triangle triangle{.a = corner,
                            .b = corner + Real(1 << random.below(3)) * x,
                            .c = corner + Real(1 << random.below(3)) * y};
    const Real t = random.eighths(1, 32);
    const Ray ray{.origin = weighted(triangle, weights) + t * z, .direction = -z};
    const bool outside = std::min({weights.x, weights.y, weights.z}) < 0;
    return outside ? misses(ray, triangle) : hits(ray, triangle, t);
}

}  // namespace

TEST_CASE("rays to points inside the triangle hit it, rays beside it miss (MRT §5)",
          "[part intersect][3 points][exact]") {
    CHECK(hits(down_at(1, 1), right_angled, 2));
    CHECK(misses(down_at(3, 3), right_angled));
    CHECK(misses(down_at(-1, 1), right_angled));
    CHECK(misses(down_at(1, -1), right_angled));
    CHECK(misses(down_at(5, Real(0.5)), right_angled));
    CHECK(for_all([](Random& random) {
        const Real x = Real(1 + random.below(15)) / 8;
        const Real y = Real(1 + random.below(15)) / 8;
        const Real t = random.eighths(1, 9);
        const Vec3 down(0, 0, -1);
        if (random.coin()) return hits({Vec3(x, y, 0) - t * down, down}, right_angled, t);
        // In the box around it.
        return misses({Vec3(4 - x / 2, 4 - y / 2, 0) - t * down, down}, right_angled);
    }));
}

TEST_CASE("rays just outside each of the three edges miss (MRT §5)") {
    CHECK(hits(down_at(1, 2), right_angled, 2));
    // Just outside one edge, well inside the other two.
    CHECK(misses(down_at(1, Real(-0.125)), right_angled));
    CHECK(misses(down_at(Real(2.125), 2), right_angled));
    CHECK(misses(down_at(Real(-0.125), 1), right_angled));
}

TEST_CASE("a triangle is hit from either side, in both orders of its corners (MRT §5)") {
    const Triangle rotated{.a = {0, 0, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}};
    CHECK(hits(down_at(1, 1), rotated, 2));
    CHECK(hits(Ray{.origin = {1, 1, -3}, .direction = {0, 0, 1}}, right_angled, 3));
    CHECK(hits(Ray{.origin = {1, 1, -3}, .direction = {0, 0, 1}}, rotated, 3));
}

TEST_CASE("a triangle is hit along directions of which some components are zero (MRT §5)") {
    // On x + y + z = 3, around (1, 1, 1).
    const Triangle leaning{.a = {3, 0, 0}, .b = {0, 3, 0}, .c = {0, 0, 3}};
    for (int i = 0; i < 125; ++i) {
        const Vec3 direction(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
        if (direction.x + direction.y + direction.z == 0) continue;  // along the plane
        CHECK(
            hits(Ray{.origin = Vec3(1) - Real(2) * direction, .direction = direction}, leaning, 2));
    }
}

TEST_CASE("rays to the edges of a triangle and the diagonal of a quad hit (erratum 5, MRT §5)",
          "[exact]") {
    const Triangle other{.a = {4, 4, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}};
    CHECK(hits(down_at(2, 2), right_angled, 2));
    CHECK(hits(down_at(2, 2), other, 2));
    CHECK(hits(down_at(2, 0), right_angled, 2));
    CHECK(hits(down_at(0, 2), right_angled, 2));
    const Triangle rotated{.a = {0, 0, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}};
    CHECK(hits(down_at(2, 2), rotated, 2));
    CHECK(hits(down_at(2, 0), rotated, 2));
    CHECK(hits(down_at(0, 2), rotated, 2));
    CHECK(for_all([](Random& random) {
        const Real part = Real(1 + random.below(7)) / 8;
        Vec3 weights(part, 1 - part, 0);
        std::swap(weights.z, weights[random.below(3)]);
        return hits_exactly_at(weights, random);
    }));
    // A hair inside, and a hair outside.
    CHECK(for_all([](Random& random) {
        const Real part = Real(1 + random.below(7)) / 8;
        const Real weight = random.coin() ? hair : -hair;
        Vec3 weights(part - weight, 1 - part, weight);
        std::swap(weights.z, weights[random.below(3)]);
        return hits_exactly_at(weights, random);
    }));
}

TEST_CASE("rays to the corners of a triangle hit (erratum 5, MRT §5)", "[exact]") {
    CHECK(hits(down_at(0, 0), right_angled, 2));
    CHECK(hits(down_at(4, 0), right_angled, 2));
    CHECK(hits(down_at(0, 4), right_angled, 2));
    CHECK(for_all([](Random& random) {
        Vec3 weights(0);
        weights[random.below(3)] = 1;
        return hits_exactly_at(weights, random);
    }));
}

TEST_CASE("a triangle behind the origin is a miss (MRT §4–5, t positive)") {
    CHECK(misses(Ray{.origin = {1, 1, 2}, .direction = {0, 0, 1}}, right_angled));
    CHECK(misses(Ray{.origin = {1, 1, -2}, .direction = {0, 0, -1}}, right_angled));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("a ray in the triangle's plane misses (MRT §5, ⟨d, n⟩ = 0)", "[exact]") {
    CHECK(misses(Ray{.origin = {-1, 1, 0}, .direction = {1, 0, 0}}, right_angled));
    CHECK(misses(Ray{.origin = {-1, 0, 0}, .direction = {1, 0, 0}}, right_angled));
    CHECK(misses(Ray{.origin = {-1, 1, 1}, .direction = {1, 0, 0}}, right_angled));
}

TEST_CASE("a triangle without area is a miss (contract)", "[exact]") {
    const Triangle line{.a = {0, 0, 0}, .b = {2, 0, 0}, .c = {4, 0, 0}};
    const Triangle point{.a = {1, 1, 0}, .b = {1, 1, 0}, .c = {1, 1, 0}};
    CHECK(misses(down_at(1, 0), line));
    CHECK(misses(down_at(1, 1), line));
    CHECK(misses(down_at(1, 1), point));
}

TEST_CASE("small triangles are hit (MRT §5)", "[exact]") {
    const Real small = std::ldexp(Real(1), -30);  // about 1e-9
    const Triangle triangle{.a = {0, 0, 0}, .b = {4 * small, 0, 0}, .c = {0, 4 * small, 0}};
    CHECK(hits(down_at(small, small), triangle, 2));
    CHECK(misses(down_at(3 * small, 3 * small), triangle));
    CHECK(for_all([&](Random& random) {
        const Real x = Real(1 + random.below(15)) / 8 * small;
        const Real y = Real(1 + random.below(15)) / 8 * small;
        const Real t = random.eighths(1, 9);
        if (random.coin()) return hits({.origin = {x, y, t}, .direction = {0, 0, -1}}, triangle, t);
        return misses({.origin = {4 * small - x, 4 * small - y, t}, .direction = {0, 0, -1}},
                      triangle);
    }));
}

TEST_CASE("narrow triangles are hit (contract)", "[exact]") {
    for (const int power : {-3, -5, -8, -11}) {
        const Real narrow = std::ldexp(Real(1), power);
        const Triangle needle{.a = {0, 0, 0}, .b = {2, narrow, 0}, .c = {2, -narrow, 0}};
        CHECK(hits(down_at(1, 0), needle, 2));
        CHECK(misses(down_at(1, narrow), needle));
        const Triangle one_short_side{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4 * narrow, 0}};
        CHECK(hits(down_at(1, narrow), one_short_side, 2));
        CHECK(misses(down_at(3, 3 * narrow), one_short_side));
    }
    CHECK(for_all([](Random& random) {
        const Real narrow = std::ldexp(Real(1), -3 - random.below(9));
        const Real length = random.eighths(2, 4);
        const Triangle needle{.a = {0, 0, 0}, .b = {length, narrow, 0}, .c = {length, -narrow, 0}};
        const Vec3 origin(random.eighths(1, 2) - Real(0.125), 0, random.eighths(1, 9));
        const Ray ray{.origin = origin, .direction = {0, 0, -1}};
        if (random.coin()) return hits(ray, needle, origin.z);
        return misses({.origin = origin + Vec3(0, narrow, 0), .direction = ray.direction}, needle);
    }));
}

TEST_CASE("a grazing ray hits the triangle (MRT §5)", "[exact]") {
    for (const int power : {-12, -40, -60}) {
        const Real slope = std::ldexp(Real(1), power);
        CHECK(
            hits(Ray{.origin = {1, -4, 5 * slope}, .direction = {0, 1, -slope}}, right_angled, 5));
        CHECK(for_all([slope](Random& random) {
            const Vec3 point(Real(1 + random.below(15)) / 8, Real(1 + random.below(15)) / 8, 0);
            const Real t = random.eighths(1, 9);
            const Vec3 direction(0, 1, -slope);
            return hits({.origin = point - t * direction, .direction = direction}, right_angled, t);
        }));
    }
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {1, 1, 2}, .direction = {0, 0, -4}}, right_angled, Real(0.5)));
    CHECK(hits(Ray{.origin = {1, 1, 2}, .direction = {0, 0, Real(-0.25)}}, right_angled, 8));
}

TEST_CASE("only hits strictly inside the interval count (contract)", "[exact]") {
    CHECK(hits(down_at(1, 1), right_angled, 2, Interval{.min = 1, .max = 3}));
    CHECK(misses(down_at(1, 1), right_angled, Interval{.min = 0, .max = 2}));
    CHECK(misses(down_at(1, 1), right_angled, Interval{.min = 2, .max = 9}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {1, 1, near}, .direction = {0, 0, -1}}, right_angled, near));
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_shape, draw));
    CHECK(far_shapes_are_hit(draw));
}

TEST_CASE("very small triangles and very short directions (contract)") {
    CHECK(hits_in(tiny_shape, draw));
    CHECK(hits_in(short_direction, draw));
    CHECK(misses_in(tiny_shape, draw_past));
    CHECK(misses_in(short_direction, draw_past));
}

TEST_CASE("rays aimed at a point of the triangle hit it there (MRT §5, M1)") {
    CHECK(aimed_rays_hit(draw));
    CHECK(aimed_rays_hit(draw_across_an_axis));
    CHECK(aimed_rays_hit(draw_almost_across_an_axis));
}

TEST_CASE("rays aimed at its plane outside the triangle miss (MRT §5, M1)") {
    CHECK(misses_in({}, draw_past));
}

TEST_CASE("rays aimed 0.1 % beside the edges of the triangle miss (MRT §5)") {
    CHECK(for_all([](Random& random) {
        const Real weight = draw_narrow(random);
        if (random.coin()) {
            const auto inside = aimed_with_weight(weight, random);
            return hits(inside.ray, inside.shape, inside.t);
        }
        const auto outside = aimed_with_weight(-weight, random);
        return misses(outside.ray, outside.shape);
    }));
}

TEST_CASE("the normal points to the side from which a, b, c are counterclockwise (MRT §5)",
          "[part normal]") {
    CHECK(normal_is(right_angled, {1, 1, 0}, {0, 0, 1}));
    CHECK(
        normal_is(Triangle{.a = {0, 0, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}}, {1, 1, 0}, {0, 0, -1}));
    CHECK(normals_point_outward(draw));
}

TEST_CASE("a hit is the same hit after everything has moved, turned and grown (HAI)",
          "[part intersect and normal]") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("a ray or shape with NaN is a miss (contract)") {
    CHECK(nan_misses(draw));
}

TEST_CASE("a corner's own weight is 1 there (erratum 7, M1)", "[part barycentric]") {
    CHECK(gives("the weights at a", barycentric(right_angled, {0, 0, 0}), Vec3(1, 0, 0)));
    CHECK(gives("the weights at b", barycentric(right_angled, {4, 0, 0}), Vec3(0, 1, 0)));
    CHECK(gives("the weights at c", barycentric(right_angled, {0, 4, 0}), Vec3(0, 0, 1)));
}

TEST_CASE("the weights give the point back, and sum to 1 (M1, CR §4.1)") {
    CHECK(gives("the weights of (1, 2, 0)", barycentric(right_angled, {1, 2, 0}),
                Vec3(Real(0.25), Real(0.25), Real(0.5))));
    CHECK(for_all([](Random& random) {
        const Triangle triangle = draw_triangle(random);
        const Vec3 w = inner_weights(random);
        const Vec3 point = weighted(triangle, w);
        return gives("barycentric(" + code(triangle) + ", " + code(point) + ")",
                     barycentric(triangle, point), w);
    }));
    CHECK(for_all([](Random& random) {  // of another size
        const Transform small{.scale = std::ldexp(Real(1), is_float ? -8 : -24)};
        const Triangle triangle = transformed(draw_triangle(random), small);
        const Vec3 w = inner_weights(random);
        const Vec3 point = weighted(triangle, w);
        return gives("barycentric(" + code(triangle) + ", " + code(point) + ")",
                     barycentric(triangle, point), w);
    }));
}

TEST_CASE("beyond an edge the opposite corner's weight is negative (M1)") {
    CHECK(gives("the weights of (4, 4, 0)", barycentric(right_angled, {4, 4, 0}), Vec3(-1, 1, 1)));
    CHECK(
        gives("the weights of (-4, 0, 0)", barycentric(right_angled, {-4, 0, 0}), Vec3(2, -1, 0)));
    CHECK(gives("the weights of (0, -2, 0)", barycentric(right_angled, {0, -2, 0}),
                Vec3(Real(1.5), 0, Real(-0.5))));
}

TEST_CASE("a triangle without area has no weights: they are NaN (contract)", "[exact]") {
    const auto none = [](const Triangle& triangle, Vec3 point) {
        const Vec3 w = barycentric(triangle, point);
        return verdict(std::isnan(w.x + w.y + w.z), "barycentric(" + code(triangle) + ", " +
                                                        code(point) + ")\n  got:      " + text(w) +
                                                        "\n  expected: NaN: 0 / 0");
    };
    CHECK(none({.a = {0, 0, 0}, .b = {2, 0, 0}, .c = {4, 0, 0}}, {1, 0, 0}));
    CHECK(none({.a = {1, 1, 0}, .b = {1, 1, 0}, .c = {1, 1, 0}}, {1, 1, 0}));
    CHECK(for_all([none](Random& random) {
        const Vec3 along = random.axes().x;
        const Vec3 a = random.point_in_eighths(3);
        const auto on_line = [&] { return a + random.eighths(-4, 4) * along; };
        return none({.a = a, .b = on_line(), .c = on_line()}, on_line());
    }));
}

TEST_CASE("the picture of the stage (MRT §5)", "[part together]") {
    CHECK(picture_matches("step05_triangle"));
}
