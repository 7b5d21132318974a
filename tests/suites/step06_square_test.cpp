// Stage 6 against MRT §6, HAI and CR §2.3–2.4.

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step06_square/square.hpp"

#include "tests/kit/nearly_vertical.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

#include "common/scene_file/reader.hpp"

using namespace rt;

namespace {

/// Side 4, in the plane z = 0, seen from above with x to the right and y upwards.
const Square flat{.center = {0, 0, 0}, .basis = {}, .side = 4};
const Ray from_below{.origin = {1, 1, -3}, .direction = {0, 0, 1}};

Ray down_at(Real x, Real y) {
    return {.origin = {x, y, 2}, .direction = {0, 0, -1}};
}

Square draw_square(Random& random) {
    return {.center = random.point(3), .basis = draw_basis(random), .side = random.between(1, 3)};
}

/// x and y in units of half a side, at most 0.9: rounding does not decide what is inside.
Sample<Square> draw(Random& random) {
    const Square square = draw_square(random);
    const Real x = random.between(Real(-0.9), Real(0.9)) * square.side / 2;
    const Real y = random.between(Real(-0.9), Real(0.9)) * square.side / 2;
    return {.shape = square,
            .point = square.center + x * square.basis.x + y * square.basis.y,
            .normal = square.basis.z};
}

/// A ray at a point whose larger coordinate is this many halves of a side.
Aimed<Square> aimed_at_frame(const Square& square, Real halves, Random& random) {
    Vec2 p(random.between(Real(-0.9), Real(0.9)), random.between(Real(-0.9), Real(0.9)));
    p[random.below(2)] = random.coin() ? -halves : halves;
    p *= square.side / 2;
    const Vec3 point = square.center + p.x * square.basis.x + p.y * square.basis.y;
    return aimed_from_outside<Square>({square, point, square.basis.z}, random);
}

Past<Square> draw_past(Random& random) {
    const Square square = draw_square(random);
    const auto aimed = aimed_at_frame(square, random.between(Real(1.1), 2), random);
    return {.ray = aimed.ray, .shape = square};
}

/// A ray at a point near the frame hits, or passes, a square with this frame.
Verdict ends_at_frame(const Square& square, Real margin, Random& random) {
    if (random.coin()) {
        const auto inside = aimed_at_frame(square, 1 - margin, random);
        return hits(inside.ray, square, inside.t);
    }
    return misses(aimed_at_frame(square, 1 + margin, random).ray, square);
}

}  // namespace

TEST_CASE("rays to points inside the square hit it, rays beside it miss (MRT §6)",
          "[part intersect][3 points]") {
    CHECK(hits(down_at(0, 0), flat, 2));
    CHECK(hits(down_at(Real(1.75), Real(-1.75)), flat, 2));
    CHECK(misses(down_at(Real(2.25), 0), flat));
    CHECK(misses(down_at(Real(-2.25), 0), flat));
    CHECK(misses(down_at(0, Real(2.25)), flat));
    CHECK(misses(down_at(0, Real(-2.25)), flat));
    CHECK(misses(down_at(3, 3), flat));
}

TEST_CASE("a square with another center (MRT §6)") {
    const Square square{.center = {5, -3, 1}, .basis = {}, .side = 2};
    CHECK(hits(down_at(Real(5.5), Real(-3.5)), square, 1));
    CHECK(misses(down_at(0, 0), square));
}

TEST_CASE("rays to the edges and corners of the square hit (erratum 5, MRT §6, CR §2.3)",
          "[exact]") {
    CHECK(hits(down_at(2, 0), flat, 2));
    CHECK(hits(down_at(-2, 1), flat, 2));
    CHECK(hits(down_at(0, 2), flat, 2));
    CHECK(hits(down_at(1, -2), flat, 2));
    CHECK(hits(down_at(2, 2), flat, 2));
    CHECK(hits(down_at(-2, 2), flat, 2));
    CHECK(for_all([](Random& random) {
        // In eighths: nothing is rounded.
        const Square square{.center = random.point_in_eighths(3),
                            .basis = random.axes(),
                            .side = Real(1 << random.below(4))};
        Vec2 p(random.eighths(-1, 1), random.eighths(-1, 1));
        p[random.below(2)] = random.coin() ? 1 : -1;
        p *= square.side / 2;
        const auto& [x, y, z] = square.basis;
        const Real t = random.eighths(1, 32);
        return hits({.origin = square.center + p.x * x + p.y * y + t * z, .direction = -z}, square,
                    t);
    }));
    // A hair inside, and a hair outside.
    CHECK(for_all([](Random& random) {
        const Square square{.center = random.point_in_eighths(3),
                            .basis = random.axes(),
                            .side = Real(1 << random.below(4))};
        const bool inside = random.coin();
        Vec2 p(random.eighths(-1, 1) / 2, random.eighths(-1, 1) / 2);
        p[random.below(2)] = (random.coin() ? 1 : -1) * (inside ? 1 - hair : 1 + hair);
        p *= square.side / 2;
        const auto& [x, y, z] = square.basis;
        const Real t = random.eighths(1, 32);
        const Ray ray{.origin = square.center + p.x * x + p.y * y + t * z, .direction = -z};
        return inside ? hits(ray, square, t) : misses(ray, square);
    }));
}

TEST_CASE("squares with other bases (MRT §6)") {
    // Turned by an eighth: its corners are on the world's axes, 2.83 away.
    const Real half = std::sqrt(Real(0.5));
    const Square rotated{.center = {0, 0, 0},
                         .basis = {.x = {half, half, 0}, .y = {-half, half, 0}, .z = {0, 0, 1}},
                         .side = 4};
    CHECK(hits(down_at(Real(2.75), 0), rotated, 2));
    CHECK(misses(down_at(Real(1.75), Real(1.75)), rotated));
    // Upright: in the plane x = 0.
    const Square upright{
        .center = {0, 0, 0}, .basis = {.x = {0, 0, -1}, .y = {0, 1, 0}, .z = {1, 0, 0}}, .side = 4};
    CHECK(hits(Ray{.origin = {3, 1, Real(1.5)}, .direction = {-1, 0, 0}}, upright, 3));
    CHECK(misses(Ray{.origin = {3, 1, Real(2.5)}, .direction = {-1, 0, 0}}, upright));
}

TEST_CASE("a square is hit from either side (MRT §6)") {
    CHECK(hits(from_below, flat, 3));
}

TEST_CASE("a one-sided square is hit from its front only (HAI)") {
    Square front_only = flat;
    front_only.one_sided = true;
    CHECK(hits(down_at(1, 1), front_only, 2));
    CHECK(misses(from_below, front_only));
    CHECK(for_all([](Random& random) {  // at any angle, with a direction of any length
        Sample<Square> sample = draw(random);
        sample.shape.one_sided = true;
        const bool behind = random.coin();
        if (behind) sample.normal = -sample.normal;
        const auto aimed = aimed_from_outside(sample, random);
        const Real length = random.power_of_two();
        const Ray ray{.origin = aimed.ray.origin, .direction = length * aimed.ray.direction};
        return behind ? misses(ray, aimed.shape) : hits(ray, aimed.shape, aimed.t / length);
    }));
}

TEST_CASE("a shape behind the origin is a miss (PHY, t positive)") {
    CHECK(misses(Ray{.origin = {0, 0, 2}, .direction = {0, 0, 1}}, flat));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("the Cornell box is visible from its front, and opaque from inside (HAI, CR §2.4)") {
    const Scene scene =
        load_scene(project_file("scenes/cornell_box.rt"), orthonormal_basis, {.strict = true});
    const auto nearest = [&scene](const Ray& ray) {
        std::optional<Real> t;
        for (const Primitive<Square>& primitive : scene.squares)
            if (const auto hit =
                    intersect(ray, primitive.shape, {.min = 0, .max = t.value_or(infinity)}))
                t = hit;
        return t;
    };
    // The box is from -1 to 1 on every axis.
    const auto in = nearest({.origin = {0, Real(0.5), 3}, .direction = {0, 0, -1}});
    const auto out = nearest({.origin = {0, Real(0.5), 0}, .direction = {0, 0, 1}});
    CHECK(verdict(in && close(*in, 4),
                  "From outside the back wall is seen, 4 ahead: came " + got_text(in)));
    CHECK(verdict(out && close(*out, 1),
                  "From inside the front wall is seen, 1 ahead: came " + got_text(out)));
}

TEST_CASE("a ray in the square's plane misses (MRT §6)", "[exact]") {
    CHECK(misses(Ray{.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, flat));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}}, flat));
    CHECK(misses(Ray{.origin = {-5, 0, 1}, .direction = {1, 0, 0}}, flat));
}

TEST_CASE("a grazing ray hits the square (MRT §6)", "[exact]") {
    Square front_only = flat;
    front_only.one_sided = true;
    for (const int power : {-20, -40, -60}) {
        const Real slope = std::ldexp(Real(1), power);
        const Ray ray{.origin = {0, -4, 5 * slope}, .direction = {0, 1, -slope}};
        CHECK(hits(ray, flat, 5));
        CHECK(hits(ray, front_only, 5));
        CHECK(for_all([slope](Random& random) {
            const Vec3 point(random.eighths(-1, 1), random.eighths(-1, 1), 0);
            const Real t = random.eighths(1, 9);
            const Vec3 direction(0, 1, -slope);
            return hits({.origin = point - t * direction, .direction = direction}, flat, t);
        }));
    }
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {1, 1, 2}, .direction = {0, 0, -4}}, flat, Real(0.5)));
    CHECK(hits(Ray{.origin = {1, 1, 2}, .direction = {0, 0, Real(-0.25)}}, flat, 8));
}

TEST_CASE("only hits strictly inside the interval count (contract)", "[exact]") {
    CHECK(misses(down_at(1, 1), flat, Interval{.min = 0, .max = 2}));
    CHECK(misses(down_at(1, 1), flat, Interval{.min = 2, .max = 9}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {1, 1, near}, .direction = {0, 0, -1}}, flat, near));
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_shape, draw));
    CHECK(far_shapes_are_hit(draw));
}

TEST_CASE("very small squares and very short directions (contract)") {
    CHECK(hits_in(tiny_shape, draw));
    CHECK(hits_in(short_direction, draw));
    CHECK(misses_in(tiny_shape, draw_past));
    CHECK(misses_in(short_direction, draw_past));
}

TEST_CASE("rays aimed at a point of the square hit it there (MRT §6)") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("rays aimed at its plane beside the square miss (MRT §6)") {
    CHECK(misses_in({}, draw_past));
}

TEST_CASE("rays aimed 0.1 % beside the edges of the square miss (MRT §6)") {
    CHECK(for_all([](Random& random) {
        const Square square = draw_square(random);
        return ends_at_frame(square, draw_narrow(random), random);
    }));
}

TEST_CASE("the normal is the square's Z (MRT §6)", "[part normal]") {
    CHECK(normal_is(flat, {1, 1, 0}, {0, 0, 1}));
    Square front_only = flat;
    front_only.one_sided = true;
    CHECK(normal_is(front_only, {1, 1, 0}, {0, 0, 1}));
    CHECK(normals_point_outward(draw));
}

TEST_CASE("u and v are 0 at the corner C and 1 at the ends of its edges (erratum 10, HAI)",
          "[part square_uv]") {
    CHECK(gives("uv at C", square_uv(flat, {-2, -2, 0}), Vec2(0, 0)));
    CHECK(gives("uv at C + U", square_uv(flat, {2, -2, 0}), Vec2(1, 0)));
    CHECK(gives("uv at C + V", square_uv(flat, {-2, 2, 0}), Vec2(0, 1)));
    CHECK(gives("uv at C + U + V", square_uv(flat, {2, 2, 0}), Vec2(1, 1)));
    CHECK(gives("uv at (1, -1, 0)", square_uv(flat, {1, -1, 0}), Vec2(Real(0.75), Real(0.25))));
    CHECK(gives("uv at (-3, 1, 0)", square_uv(flat, {-3, 1, 0}), Vec2(Real(-0.25), Real(0.75))));
    CHECK(for_all([](Random& random) {
        Square square = draw_square(random);
        square.side *= random.coin() ? Real(0.125) : Real(4);
        const Vec2 uv(random.between(-1, 2), random.between(-1, 2));
        const Vec3 corner = square.center - square.side / 2 * (square.basis.x + square.basis.y);
        const Vec3 point = corner + square.side * (uv.x * square.basis.x + uv.y * square.basis.y);
        return gives("square_uv(" + code(square) + ", " + code(point) + ")",
                     square_uv(square, point), uv);
    }));
}

TEST_CASE("rays to the edges of a square whose Z is almost vertical (contract)",
          "[part together]") {
    CHECK(for_all([](Random& random) {
        Square square = draw_square(random);
        square.basis = nearly_vertical_basis(random);
        return ends_at_frame(square, random.between(Real(0.0002), Real(0.2)), random);
    }));
    CHECK(for_all([](Random& random) {
        Square square = draw_square(random);
        square.basis = nearly_vertical_basis(random);
        const Vec2 uv(random.between(0, 1), random.between(0, 1));
        const Vec2 p = square.side * (uv - Real(0.5));
        const Vec3 point = square.center + p.x * square.basis.x + p.y * square.basis.y;
        return gives("square_uv(" + code(square) + ", " + code(point) + ")",
                     square_uv(square, point), uv);
    }));
}

TEST_CASE("a hit is the same hit after everything has moved, turned and grown (HAI)") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("a ray or shape with NaN is a miss (contract)") {
    CHECK(nan_misses(draw));
}

TEST_CASE("the picture of the stage (MRT §6, HAI)") {
    CHECK(picture_matches("step06_square"));
}

TEST_CASE("the picture of the Cornell box (HAI, CR §2.4)") {
    CHECK(picture_matches("cornell_box"));
}
