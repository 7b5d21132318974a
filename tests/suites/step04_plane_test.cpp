// Stage 4 against MRT §4, M1 and PHY.
#include "steps/step04_plane/plane.hpp"

#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

using namespace rt;

namespace {

const Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};

Sample<Plane> draw(Random& random) {
    const Basis basis = draw_basis(random);
    const Vec3 point = random.point(3);
    const Vec3 other = point + random.between(-2, 2) * basis.x + random.between(-2, 2) * basis.y;
    return {.shape = {.point = point, .normal = basis.z}, .point = other, .normal = basis.z};
}

}  // namespace

TEST_CASE("situation A: t = 0.5333 at (1.467, -1.933, -0.6) (PHY)", "[part intersect][3 points]") {
    const Ray ray{.origin = {2, -3, 1}, .direction = {-1, 2, -3}};
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    CHECK(hits(ray, plane, Real(8) / 15));
    CHECK(hits(ray, Plane{.point = {-2, 2, 2}, .normal = {Real(0.6), 0, Real(0.8)}}, Real(8) / 15));
    CHECK(gives("at(ray, 8/15)", at(ray, Real(8) / 15),
                Vec3(Real(22) / 15, Real(-29) / 15, Real(-3) / 5)));
}

TEST_CASE("a plane is hit from either side (MRT §4)") {
    CHECK(hits(Ray{.origin = {3, 2, 1}, .direction = {0, -1, 0}}, ground, 2));
    CHECK(hits(Ray{.origin = {3, -2, 1}, .direction = {0, 1, 0}}, ground, 2));
    CHECK(hits(Ray{.origin = {0, 3, 0}, .direction = {1, -1, 1}}, ground, 3));
}

TEST_CASE("planes across each axis are hit (MRT §4)") {
    const Vec3 point(1, 2, 3);
    const Vec3 direction(2, -1, 4);
    for (int axis = 0; axis < 3; ++axis) {
        Plane plane{.point = point, .normal = Vec3(0)};
        plane.normal[axis] = 3;
        CHECK(hits(Ray{.origin = point - Real(5) * direction, .direction = direction}, plane, 5));
    }
}

TEST_CASE("a plane given by different points of it (MRT §4)") {
    const Ray ray{.origin = {0, 5, 0}, .direction = {0, -1, 0}};
    CHECK(hits(ray, Plane{.point = {7, 1, -9}, .normal = {0, 1, 0}}, 4));
    CHECK(hits(ray, Plane{.point = {2, 0, 0}, .normal = {1, 2, 0}}, 4));
}

TEST_CASE("normals of several lengths and of both signs give the same t (PHY, N and n)") {
    const Ray ray{.origin = {0, 5, 0}, .direction = {0, -1, 0}};
    CHECK(hits(ray, Plane{.point = {0, 1, 0}, .normal = {0, 8, 0}}, 4));
    CHECK(hits(ray, Plane{.point = {0, 1, 0}, .normal = {0, Real(-0.25), 0}}, 4));
}

TEST_CASE("a plane behind the origin is a miss (MRT §4, t positive)") {
    CHECK(misses(Ray{.origin = {0, 2, 0}, .direction = {0, 1, 0}}, ground));
    CHECK(misses(Ray{.origin = {0, -2, 0}, .direction = {1, -1, 0}}, ground));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("a parallel ray misses, above the plane and in it (MRT §4)", "[exact]") {
    CHECK(misses(Ray{.origin = {0, 2, 0}, .direction = {1, 0, 0}}, ground));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}}, ground));
    CHECK(misses(Ray{.origin = {0, 2, 0}, .direction = {3, 0, -4}}, ground));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {1, -1, 0}},
                 Plane{.point = {4, 0, 0}, .normal = {1, 1, 0}}));
}

TEST_CASE("a grazing ray hits the plane far away (MRT §4)", "[exact]") {
    for (const int power : {-40, -60}) {  // about 1e-12 and 1e-18
        const Real slope = std::ldexp(Real(1), power);
        CHECK(hits(Ray{.origin = {0, 2, 0}, .direction = {1, -slope, 0}}, ground, 2 / slope));
        CHECK(misses(Ray{.origin = {0, 2, 0}, .direction = {1, slope, 0}}, ground));
        CHECK(hits(Ray{.origin = {0, -1, 0}, .direction = {0, slope, -1}}, ground, 1 / slope));
        CHECK(for_all([slope](Random& random) {
            // In eighths: nothing is rounded.
            const auto [along, across, up] = random.axes();
            const Plane plane{.point = random.point_in_eighths(3), .normal = up};
            const Real height = random.eighths(1, 4);
            const Vec3 origin = plane.point + random.eighths(-4, 4) * across + height * up;
            if (random.coin()) return misses({origin, along + slope * up}, plane);
            return hits({origin, along - slope * up}, plane, height / slope);
        }));
    }
}

TEST_CASE("rays below the horizon hit further and further away, rays above it miss (MRT §4)") {
    const Vec3 eye(0, 1, 0);
    Real before = 0;
    for (const Real depth : {Real(1), Real(0.25), Real(0.0625), Real(0.015625)}) {
        const std::optional<Real> t = intersect({eye, {0, -depth, -1}}, ground, {});
        REQUIRE(t);
        CHECK(close(*t, 1 / depth));
        CHECK(*t > before);
        before = *t;
        CHECK(misses(Ray{.origin = eye, .direction = {0, depth, -1}}, ground));
    }
}

TEST_CASE("a ray from a point of the plane is a miss (PHY, t > 0)", "[exact]") {
    CHECK(misses(Ray{.origin = {5, 0, 5}, .direction = {1, 1, 0}}, ground));
    CHECK(misses(Ray{.origin = {5, 0, 5}, .direction = {1, -1, 0}}, ground));
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {0, 4, 0}, .direction = {0, -8, 0}}, ground, Real(0.5)));
    CHECK(hits(Ray{.origin = {0, 4, 0}, .direction = {0, Real(-0.125), 0}}, ground, 32));
}

TEST_CASE("only hits strictly inside the interval count (contract)", "[exact]") {
    const Ray ray{.origin = {0, 2, 0}, .direction = {0, -1, 0}};
    CHECK(hits(ray, ground, 2, Interval{.min = 1, .max = 3}));
    CHECK(misses(ray, ground, Interval{.min = 0, .max = 2}));
    CHECK(misses(ray, ground, Interval{.min = 2, .max = 9}));
    CHECK(misses(ray, ground, Interval{.min = 1, .max = 2}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {3, near, 1}, .direction = {0, -1, 0}}, ground, near));
    CHECK(hits(Ray{.origin = {3, -near, 1}, .direction = {1, 1, 0}}, ground, near));
    const Real nearer = std::ldexp(Real(1), -40);
    CHECK(hits(Ray{.origin = {3, nearer, 1}, .direction = {0, -1, 0}}, ground, nearer));
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_shape, draw));
    CHECK(hits_in(tiny_shape, draw));
}

TEST_CASE("very short directions (contract)") {
    CHECK(hits_in(short_direction, draw));
}

TEST_CASE("rays aimed at a point of the plane hit it there (MRT §4)") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("rays aimed at a point of the plane from its other side hit it there (MRT §4)") {
    CHECK(for_all([](Random& random) {
        Sample<Plane> sample = draw(random);
        sample.normal = -sample.normal;
        const auto aimed = aimed_from_outside(sample, random);
        return hits(aimed.ray, aimed.shape, aimed.t);
    }));
}

TEST_CASE("the normal is the plane's, with unit length (PHY, situation A)", "[part normal]") {
    CHECK(normal_is(Plane{.point = {0, 0, 0}, .normal = {0, 0, -5}}, {1, 1, 0}, {0, 0, -1}));
    CHECK(normal_is(Plane{.normal = {0, 0, Real(-0.25)}}, {1, 1, 0}, {0, 0, -1}));
    for (const int power : {-20, 20}) {
        const Plane plane{.normal = {0, std::ldexp(Real(1), power), 0}};
        CHECK(normal_is(plane, {1, 0, 1}, {0, 1, 0}));
        CHECK(hits(Ray{.origin = {0, 2, 0}, .direction = {0, -1, 0}}, plane, 2));
    }
    CHECK(normal_is(Plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}}, {-2, 2, 2},
                    {Real(0.6), 0, Real(0.8)}));
    CHECK(normals_point_outward(draw));
    CHECK(for_all([](Random& random) {
        const Vec3 direction = draw_basis(random).z;
        const Plane plane{.point = random.point(3), .normal = draw_length(random) * direction};
        return normal_is(plane, plane.point, direction);
    }));
}

TEST_CASE("a hit is the same hit after everything has moved, turned and grown (HAI)",
          "[part together]") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("a ray or shape with NaN is a miss (contract)") {
    CHECK(nan_misses(draw));
}

TEST_CASE("the picture of the stage (MRT §4)") {
    CHECK(picture_matches("step04_plane"));
}
