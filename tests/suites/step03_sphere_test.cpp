// Stage 3 against MRT §3, M1, HAI, CR §2.1–2.2 and PHY.
#include "common/render/closest_hit.hpp"

#include "steps/step03_sphere/sphere.hpp"

#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

using namespace rt;

namespace {

const Sphere unit_sphere{.center = {0, 0, 0}, .radius = 1};
const Ray ahead{.origin = {0, 0, 5}, .direction = {0, 0, -1}};

Sample<Sphere> draw(Random& random) {
    const Sphere sphere{.center = random.point(3), .radius = random.between(Real(0.5), 2)};
    const Vec3 normal = random.direction();
    return {.shape = sphere, .point = sphere.center + sphere.radius * normal, .normal = normal};
}

/// Through a point outside, at right angles to the line to the center: no other point is closer.
Past<Sphere> draw_past(Random& random) {
    const Sphere sphere = draw(random).shape;
    const Basis basis = random.basis();
    const Real distance = sphere.radius * (1 + draw_gap(random));
    const Vec3 passed = sphere.center + distance * basis.x;
    const Real back = random.between(-4, 4);
    return {.ray = {.origin = passed - back * basis.y, .direction = basis.y}, .shape = sphere};
}

/// As `draw_past`, but through the inside, close to the surface.
Verdict hits_almost_touching(Random& random) {
    const Sphere sphere = draw(random).shape;
    const Basis basis = random.basis();
    const Real depth = draw_gap(random) / 2 * sphere.radius;
    const Real half_chord = std::sqrt(depth * (2 * sphere.radius - depth));
    const Real back = random.between(2, 4);
    const Vec3 closest = sphere.center + (sphere.radius - depth) * basis.x;
    const Ray ray{.origin = closest - back * basis.y, .direction = basis.y};
    const std::optional<Real> t = intersect(ray, sphere, {});
    const Real near = back - half_chord;
    return verdict(t && std::abs(*t - near) < half_chord / 8,
                   intersection_report(ray, sphere, {}, t, near));
}

/// In eighths, the radius a power of two: with rays along the axes nothing is rounded.
Sphere draw_in_eighths(Random& random) {
    return {.center = random.point_in_eighths(3), .radius = Real(1 << random.below(3))};
}

}  // namespace

TEST_CASE("the unit sphere five ahead is hit at t = 4 (MRT §3)", "[part intersect][3 points]") {
    CHECK(hits(ahead, unit_sphere, 4));
}

TEST_CASE("spheres of other radii and centers (MRT §3)") {
    CHECK(hits(ahead, Sphere{.center = {0, 0, 0}, .radius = 2}, 3));
    CHECK(hits(ahead, Sphere{.center = {0, 0, -3}, .radius = 1}, 7));
    CHECK(hits(ahead, Sphere{.center = {3, 0, 0}, .radius = 5}, 1));
    CHECK(misses(ahead, Sphere{.center = {2, 0, 0}, .radius = 1}));
    CHECK(misses(ahead, Sphere{.center = {0, -2, 0}, .radius = 1}));
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -2}}, unit_sphere, 2));
    CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, Real(-0.25)}}, unit_sphere, 16));
    // d = (0, −3, 5), ‖d‖² = 34: a ray to the center from three lengths away.
    CHECK(hits(Ray{.origin = {0, 9, -15}, .direction = {0, -3, 5}},
               Sphere{.center = {0, 0, 0}, .radius = 1}, 3 - 1 / std::sqrt(Real(34))));
}

TEST_CASE("situation B, as it is given and as it is worked, is a miss (PHY)") {
    const Ray ray{.origin = {3, 2, 0}, .direction = {0, -3, 5}};
    CHECK(misses(ray, Sphere{.center = {1, 0, -3}, .radius = 3}));
    CHECK(misses(ray, Sphere{.center = {1, -3, 0}, .radius = 3}));
}

TEST_CASE("a ray tangent to the sphere hits it (PHY, B² − 4AC = 0)", "[exact]") {
    CHECK(hits(Ray{.origin = {0, 1, 5}, .direction = {0, 0, -1}}, unit_sphere, 5));
    CHECK(hits(Ray{.origin = {-3, 0, -2}, .direction = {2, 0, 0}},
               Sphere{.center = {0, 0, 0}, .radius = 2}, Real(1.5)));
    CHECK(for_all([](Random& random) {
        const Sphere sphere = draw_in_eighths(random);
        const Basis axes = random.axes();
        const Real t = random.eighths(1, 32);
        const Vec3 touched = sphere.center + sphere.radius * axes.x;
        return hits({.origin = touched - t * axes.y, .direction = axes.y}, sphere, t);
    }));
    CHECK(for_all(hits_almost_touching));
}

TEST_CASE("a ray from inside hits the far side (MRT §3, the smallest positive root)") {
    CHECK(hits(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, unit_sphere, 1));
    CHECK(hits(Ray{.origin = {0, 0, Real(0.5)}, .direction = {0, 0, -1}}, unit_sphere, Real(1.5)));
    // PHY's situation B with a radius that reaches the origin: A = 34, B = −30, C = 29 − 36 = −7.
    CHECK(hits(Ray{.origin = {3, 2, 0}, .direction = {0, -3, 5}},
               Sphere{.center = {1, -3, 0}, .radius = 6}, (30 + std::sqrt(Real(1852))) / 68));
    CHECK(for_all([](Random& random) {
        const Sample<Sphere> sample = draw(random);
        const Real depth = random.between(Real(0.1), Real(0.9));
        const Vec3 origin = sample.shape.center + depth * sample.shape.radius * random.direction();
        return hits({.origin = origin, .direction = sample.point - origin}, sample.shape, 1);
    }));
}

TEST_CASE("a sphere behind the origin is a miss (CR §2.2, PHY)") {
    CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, 1}}, unit_sphere));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE(
    "a ray from a point of the sphere: out of it a miss, into it a hit of the far side (PHY, t > "
    "0)",
    "[exact]") {
    CHECK(misses(Ray{.origin = {0, 0, 1}, .direction = {0, 0, 1}}, unit_sphere));
    CHECK(hits(Ray{.origin = {0, 0, 1}, .direction = {0, 0, -1}}, unit_sphere, 2));
    CHECK(for_all([](Random& random) {
        const Sphere sphere = draw_in_eighths(random);
        const Vec3 out = random.axes().x;
        const Vec3 origin = sphere.center + sphere.radius * out;
        if (random.coin()) return misses({.origin = origin, .direction = out}, sphere);
        return hits({.origin = origin, .direction = -out}, sphere, 2 * sphere.radius);
    }));
}

TEST_CASE("only hits strictly inside the interval count (contract)", "[exact]") {
    CHECK(hits(ahead, unit_sphere, 6, Interval{.min = 4, .max = infinity}));
    CHECK(hits(ahead, unit_sphere, 6, Interval{.min = 5, .max = 7}));
    CHECK(misses(ahead, unit_sphere, Interval{.min = 0, .max = 4}));
    CHECK(misses(ahead, unit_sphere, Interval{.min = 4, .max = 6}));
    const Ray from_inside{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(misses(from_inside, unit_sphere, Interval{.min = 0, .max = 1}));
    CHECK(misses(from_inside, unit_sphere, Interval{.min = 1, .max = 9}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (CR §2.1)") {
    CHECK(
        hits(Ray{.origin = {0, 0, Real(1.25)}, .direction = {0, 0, -1}}, unit_sphere, Real(0.25)));
    CHECK(hits(Ray{.origin = {0, 0, 101}, .direction = {0, 0, -1}}, unit_sphere, 100));
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_shape, draw));
    CHECK(far_shapes_are_hit(draw));
    CHECK(close_surfaces_are_hit(draw));
    CHECK(for_all([](Random& random) {  // a hair outside, and a hair inside
        const Sphere sphere = draw_in_eighths(random);
        const Vec3 out = random.axes().x;
        const bool outside = random.coin();
        const Real share = outside ? 1 + hair : 1 - hair;
        const Vec3 origin = sphere.center + share * sphere.radius * out;
        return hits({.origin = origin, .direction = outside ? -out : out}, sphere,
                    hair * sphere.radius);
    }));
}

TEST_CASE("very small spheres and very short directions (contract)") {
    CHECK(hits_in(tiny_shape, draw));
    CHECK(hits_in(short_direction, draw));
    CHECK(misses_in(tiny_shape, draw_past));
    CHECK(misses_in(short_direction, draw_past));
}

TEST_CASE("rays aimed at a point of the sphere hit it there (MRT §3)") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("rays aimed past the sphere miss it (MRT §3)") {
    CHECK(misses_in({}, draw_past));
    if (is_float) return;  // a textbook's discriminant has no digit left there
    const Sphere far{.center = {0, 0, -1000}, .radius = Real(0.02)};
    for (const Real radii : {Real(1.01), Real(-1.01)})
        CHECK(misses({.origin = {radii * far.radius, 0, 0}, .direction = {0, 0, -1}}, far));
}

TEST_CASE("the normal points away from the center, with unit length (M1)", "[part normal]") {
    CHECK(normal_is(Sphere{.center = {1, 2, 3}, .radius = 2}, {1, 2, 5}, {0, 0, 1}));
    CHECK(normal_is(Sphere{.center = {1, 2, 3}, .radius = 2}, {-1, 2, 3}, {-1, 0, 0}));
    CHECK(normals_point_outward(draw));
    CHECK(for_all([](Random& random) {  // of any size
        const Transform tiny{.scale = std::ldexp(Real(1), tiny_shape.size)};
        const auto [sphere, point, normal] = draw(random);
        return normal_is(transformed(sphere, tiny), transformed(point, tiny), normal);
    }));
}

TEST_CASE("a hit is the same hit after everything has moved, turned and grown (HAI)",
          "[part intersect and normal]") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("a ray or shape with NaN is a miss (contract)") {
    CHECK(nan_misses(draw));
}

TEST_CASE("the closest of several spheres is seen, in any order (M1, CR §2.1)") {
    const Primitive<Sphere> near{.shape = {.center = {0, 0, 1}, .radius = 1},
                                 .material = {Color(1, 0, 0)}};
    const Primitive<Sphere> far{.shape = {.center = {0, 0, -2}, .radius = 2},
                                .material = {Color(0, 1, 0)}};
    for (const auto& spheres :
         {PrimitiveList<Sphere>({near, far}), PrimitiveList<Sphere>({far, near})}) {
        Context context;
        ClosestHit closest(ahead, context);
        closest.test(spheres);
        const std::optional<Hit> hit = closest.hit();
        REQUIRE(hit);
        CHECK(close(hit->t, 3));
        CHECK(hit->material->color == Color(1, 0, 0));
        CHECK(gives("the hit's point", hit->point, Vec3(0, 0, 2)));
        CHECK(gives("the hit's normal", hit->normal, Vec3(0, 0, 1)));
    }
}

TEST_CASE("a normal's color is the size of its coordinates (M1)", "[part color_from_normal]") {
    CHECK(gives("color_from_normal({0, 0, -1})", color_from_normal({0, 0, -1}), Color(0, 0, 1)));
    CHECK(gives("color_from_normal({-3, 0, 4})", color_from_normal({-3, 0, 4}),
                Color(Real(0.6), 0, Real(0.8))));
    CHECK(gives("color_from_normal({0.375, 0, -0.5})",
                color_from_normal({Real(0.375), 0, Real(-0.5)}), Color(Real(0.6), 0, Real(0.8))));
    CHECK(for_all([](Random& random) {
        const Vec3 direction = random.direction();
        const Vec3 normal = draw_length(random) * direction;
        return gives("color_from_normal(" + code(normal) + ")", color_from_normal(normal),
                     Color(abs(direction)));
    }));
}

TEST_CASE("the torch lights by the cosine between normal and eye (M1)", "[part torch]") {
    const Vec3 point(1, 1, 1);
    const Vec3 eye(1, 1, 4);
    const auto lights = [](Vec3 p, Vec3 n, Vec3 viewer, Real expected) {
        return gives("torch(" + code(p) + ", " + code(n) + ", " + code(viewer) + ")",
                     torch(p, n, viewer), expected);
    };
    CHECK(lights(point, {0, 0, 1}, eye, 1));
    CHECK(lights(point, {0, 3, 4}, eye, Real(0.8)));
    CHECK(lights(point, {1, 0, 0}, eye, 0));
    CHECK(lights(point, {0, 0, -1}, eye, 0));
    CHECK(lights(point, {0, 0, 1}, Vec3(4, 1, 5), Real(0.8)));
    CHECK(lights(point, {0, 0, 1}, point, 0));  // no direction, hence no angle
    CHECK(lights(point, {0, 0, Real(0.125)}, eye, 1));
    const Real grazing = Real(0.00048828125);
    CHECK(lights(Vec3(0), {0, 0, 1}, {1, 0, grazing}, grazing / std::sqrt(1 + grazing * grazing)));
    CHECK(for_all([&](Random& random) {  // lengths do not matter
        const Basis basis = random.basis();
        const Real angle = random.between(0, pi / 2 - Real(0.0001));
        const Vec3 n = draw_length(random) * basis.z;
        const Vec3 away = std::cos(angle) * basis.z + std::sin(angle) * basis.x;
        return lights(Vec3(0), n, draw_length(random) * away, std::cos(angle));
    }));
}

TEST_CASE("the picture of the stage (HAI; CR §2.2)", "[part together]") {
    CHECK(picture_matches("step03_sphere"));
}
