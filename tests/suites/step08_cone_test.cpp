// Stage 8 against MRT §8, its coefficient put right.
#include "steps/step08_cone/cone.hpp"

#include "tests/kit/nearly_vertical.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

using namespace rt;

namespace {

/// Opens upwards from the origin; at z_p = 4 its radius is 2: (r / h)² = 1/4.
const Cone upward{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 2, .height = 4};
/// As wide as high: its side is at 45°.
const Cone right_angled{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 4, .height = 4};

/// Never at 45°, where a ray along the normal is along the side opposite.
Cone draw_cone(Random& random, Vec3 axis) {
    return {.apex = random.point(3),
            .axis = axis,
            .radius = random.between(Real(0.5), Real(0.9)),
            .height = random.between(1, 2)};
}

/// This share of the height away from the apex.
Sample<Cone> draw_at(Real share, Random& random) {
    const Basis basis = draw_basis(random);
    const Cone cone = draw_cone(random, basis.z);
    const Real z = share * cone.height;
    const Real slope = cone.radius / cone.height;
    const Vec3 n = basis.x - slope * basis.z;
    return {.shape = cone,
            .point = cone.apex + z * (basis.z + slope * basis.x),
            .normal = n / std::sqrt(dot(n, n))};
}

/// Between 0.2 and 0.9 of the height: rounding does not decide what is within it, and the apex,
/// where the normal is undefined, is not near.
Sample<Cone> draw(Random& random) {
    return draw_at(random.between(Real(0.2), Real(0.9)), random);
}

/// Across the cone, in the plane that touches it, moved outwards: nothing is nearer.
Past<Cone> draw_past(Random& random) {
    const Sample<Cone> sample = draw(random);
    const Vec3 across = cross(sample.shape.axis, sample.normal);
    const Vec3 along = across / std::sqrt(dot(across, across));
    const Vec3 passed = sample.point + draw_gap(random) * sample.shape.radius * sample.normal;
    const Real back = random.between(-4, 4);
    return {.ray = {.origin = passed - back * along, .direction = along}, .shape = sample.shape};
}

/// As `draw_past`, but through the inside, close to the surface.
Verdict hits_almost_touching(Random& random) {
    const auto [cone, point, normal] = draw(random);
    const Vec3 along = unit(cross(cone.axis, normal));
    // Across the axis, where the cone is a circle.
    const Vec3 from_apex = point - cone.apex;
    const Vec3 inwards = dot(from_apex, cone.axis) * cone.axis - from_apex;
    const Real depth = draw_gap(random) / 2;
    const Real half_chord = length(inwards) * std::sqrt(depth * (2 - depth));
    const Real back = random.between(1, 4);
    const Ray ray{.origin = point + depth * inwards - back * along, .direction = along};
    const std::optional<Real> t = intersect(ray, cone, {});
    const Real near = back - half_chord;
    return verdict(t && std::abs(*t - near) < half_chord / 8,
                   intersection_report(ray, cone, {}, t, near));
}

/// As `draw`, but long, and almost or exactly upright.
Sample<Cone> draw_upright(Random& random) {
    const Basis basis = nearly_vertical_basis(random);
    Cone cone = draw_cone(random, basis.z);
    cone.height = random.between(2, 4);
    const Real z = random.between(Real(0.2), Real(0.9)) * cone.height;
    const Real slope = cone.radius / cone.height;
    return {.shape = cone,
            .point = cone.apex + z * (basis.z + slope * basis.x),
            .normal = unit(basis.x - slope * basis.z)};
}

/// The point with this z_p on the cone's side, or on its extension at either end, rotated by an
/// angle from the basis' x around its z, the axis.
Vec3 on_side(const Cone& cone, const Basis& basis, Real z, Real angle) {
    const Vec3 across = std::cos(angle) * basis.x + std::sin(angle) * basis.y;
    return cone.apex + z * (basis.z + cone.radius / cone.height * across);
}

/// A ray that crosses the extension of the side, `passed` heights from the apex, hits the side
/// behind it, a third to two thirds of a turn around the axis: a line has no third such point.
Verdict hits_behind(Real passed, Random& random) {
    const Basis basis = random.basis();
    const Cone cone = draw_cone(random, basis.z);
    const Vec3 point = on_side(cone, basis, random.between(Real(0.2), Real(0.9)) * cone.height, 0);
    const Real angle = random.between(2 * pi / 3, 4 * pi / 3);
    const Vec3 before = on_side(cone, basis, passed * cone.height, angle);
    const Vec3 origin = before + random.between(Real(0.1), 1) * (before - point);
    const Real t = random.between(Real(0.25), 4);
    return hits({.origin = origin, .direction = (point - origin) / t}, cone, t);
}

/// A ray at up to 45° to the rim's plane, from outside or from inside, where it may come through
/// the open end, hits the side a little before the rim, or misses a little beyond it. A small cone
/// near the world's origin: in float a textbook's formula has z_p to 10^-5 there, and the margin is
/// 12·10^-5.
Verdict ends_at_its_rim(Random& random) {
    constexpr Real margin = Real(0x1p-14);
    const Basis basis = random.basis();
    const Cone cone{.apex = random.point(Real(0.25)),
                    .axis = basis.z,
                    .radius = random.between(Real(0.5), Real(0.9)),
                    .height = random.between(2, 3)};
    const bool inside = random.coin();
    const Vec3 point = on_side(cone, basis, (inside ? 1 - margin : 1 + margin) * cone.height, 0);
    const Real t = random.between(Real(0.5), 1) * cone.radius;
    const bool outwards = random.coin();
    // Beyond the rim and inwards, it leads away from the cone: another hit is not possible.
    const Real slope = random.between(outwards || inside ? -1 : 0, 1);
    const Vec3 direction = (outwards ? basis.x : -basis.x) + slope * basis.z;
    const Ray ray{.origin = point - t * direction, .direction = direction};
    return inside ? hits(ray, cone, t) : misses(ray, cone);
}

/// A ray across the axis, a little beyond the apex, misses: the other nappe is not there.
Verdict ends_at_its_apex(Random& random) {
    constexpr Real margin = Real(0x1p-14);
    const Basis basis = random.basis();
    Cone cone = draw_cone(random, basis.z);
    cone.apex = random.point(Real(0.25));
    const Vec3 beyond = cone.apex - margin * cone.height * basis.z;
    const Real back = random.between(Real(0.5), 1);
    return misses({.origin = beyond - back * basis.x, .direction = basis.x}, cone);
}

/// Multiplied by h², as well as by itself, the discriminant contains six lengths.
constexpr Units small_cone = is_float ? Units{.size = -16} : tiny_shape;
constexpr Units huge_cone = is_float ? Units{.size = 10} : huge_shape;

struct Across {
    Cone cone;
    Vec3 x;  ///< at right angles to the axis
    Vec3 y;  ///< the axis
};

/// As wide as high, a power of two; in eighths, along the axes: with rays along x, y and across
/// both, nothing is rounded.
Across draw_in_eighths(Random& random) {
    const auto [x, y, z] = random.axes();
    const Real height = Real(4 << random.below(3));
    return {
        .cone = {.apex = random.point_in_eighths(3), .axis = y, .radius = height, .height = height},
        .x = x,
        .y = y};
}

}  // namespace

TEST_CASE("rays across a cone with r / h = 1/2 at several heights (erratum 4, MRT §8)",
          "[part intersect][3 points][exact]") {
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, upward, 4));
    CHECK(hits(Ray{.origin = {0, 1, 5}, .direction = {0, 0, -1}}, upward, Real(4.5)));
    CHECK(hits(Ray{.origin = {-6, 1, 0}, .direction = {1, 0, 0}}, upward, Real(5.5)));
    CHECK(misses(Ray{.origin = {Real(1.5), 2, 5}, .direction = {0, 0, -1}}, upward));
    CHECK(for_all([](Random& random) {
        const Real up = random.between(Real(0.5), 2);
        return hits(Ray{.origin = {0, up, 5}, .direction = {0, 0, -1}}, upward, 5 - up / 2);
    }));
}

TEST_CASE("rays just inside and just outside the height of cones with opposite axes (MRT §8)") {
    CHECK(hits(Ray{.origin = {0, 3, 5}, .direction = {0, 0, -1}}, upward, Real(3.5)));
    CHECK(hits(Ray{.origin = {0, Real(3.75), 5}, .direction = {0, 0, -1}}, upward, Real(3.125)));
    CHECK(misses(Ray{.origin = {0, Real(4.25), 5}, .direction = {0, 0, -1}}, upward));
    const Cone downward{.apex = {0, 4, 0}, .axis = {0, -1, 0}, .radius = 2, .height = 4};
    CHECK(hits(Ray{.origin = {0, 1, 5}, .direction = {0, 0, -1}}, downward, Real(3.5)));
    CHECK(misses(Ray{.origin = {0, Real(-0.5), 5}, .direction = {0, 0, -1}}, downward));
}

TEST_CASE(
    "the radius of a cone with r = 1 and h = 2 at its height and half-way (erratum 4, MRT §8)",
    "[exact]") {
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    CHECK(hits(Ray{.origin = {0, Real(1.75), 5}, .direction = {0, 0, -1}}, cone, Real(4.125)));
    CHECK(misses(Ray{.origin = {Real(1.25), 2, 5}, .direction = {0, 0, -1}}, cone));
    // Half-way to the apex the radius is 0.5, where the printed one is 0.707.
    CHECK(hits(Ray{.origin = {-5, 1, 0}, .direction = {1, 0, 0}}, cone, Real(4.5)));
    CHECK(misses(Ray{.origin = {-5, 1, Real(0.625)}, .direction = {1, 0, 0}}, cone));
    CHECK(for_all([](Random& random) {
        auto [random_cone, x, y] = draw_in_eighths(random);
        random_cone.height *= random.coin() ? Real(2) : Real(0.25);  // higher than wide, or flat
        const Real z = random.between(Real(0.2), Real(0.9)) * random_cone.height;
        const Real across = z * random_cone.radius / random_cone.height;
        const Real t = random.eighths(1, 32);
        return hits({random_cone.apex + z * y + (across + t) * x, -x}, random_cone, t);
    }));
}

TEST_CASE("a ray across the axis beyond the apex misses (MRT §8, 0 ≤ z_p)") {
    CHECK(misses(Ray{.origin = {0, -2, 5}, .direction = {0, 0, -1}}, upward));
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, upward, 4));
}

TEST_CASE("a shape behind the origin is a miss (PHY, t positive)") {
    CHECK(misses(Ray{.origin = {0, 2, 5}, .direction = {0, 0, 1}}, upward));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("cones along other axes (MRT §8)") {
    const Cone along_x{.apex = {1, 0, 0}, .axis = {1, 0, 0}, .radius = 2, .height = 4};
    CHECK(hits(Ray{.origin = {3, 5, 0}, .direction = {0, -1, 0}}, along_x, 4));
    CHECK(misses(Ray{.origin = {0, 5, 0}, .direction = {0, -1, 0}}, along_x));
    const Cone tilted{
        .apex = {0, 0, 0}, .axis = {Real(0.6), Real(0.8), 0}, .radius = 5, .height = 5};
    // Four along its axis it is four wide.
    CHECK(hits(Ray{.origin = {Real(2.4), Real(3.2), 10}, .direction = {0, 0, -3}}, tilted, 2));
}

TEST_CASE("rays in through the open end: a hit of the side, a miss beside it (MRT §8)") {
    // In through the open end at the height, out through the side.
    CHECK(hits(Ray{.origin = {Real(0.5), 6, 0}, .direction = {0, -1, 0}}, upward, 5));
    CHECK(misses(Ray{.origin = {Real(1.75), Real(4.5), 0}, .direction = {1, -1, 0}}, upward));
}

TEST_CASE("a ray into the open end hits the far inside (MRT §8)") {
    // At t = 2 it passes over the near side at y = 6, above the rim. At t = 6 it hits the far one.
    CHECK(hits(Ray{.origin = {0, 8, 5}, .direction = {0, -1, -1}}, upward, 6));
}

TEST_CASE("a ray from beyond the apex into the cone hits the side (MRT §8, 0 ≤ z_p)") {
    // The near root is on the nappe that is not there, the far one on the one that is.
    CHECK(hits(Ray{.origin = {Real(0.5), -5, 0}, .direction = {0, 1, 0}}, upward, 6));
    CHECK(for_all([](Random& random) {
        return hits_behind(-random.between(Real(0.01), Real(0.9)), random);
    }));
}

TEST_CASE("a ray parallel to a line of the side (erratum 6, MRT §8)", "[exact]") {
    // a = 0: the direction is that of a line of the cone's side.
    CHECK(hits(Ray{.origin = {0, -1, 2}, .direction = {0, 1, -1}}, right_angled, Real(1.5)));
    CHECK(hits(Ray{.origin = {0, 0, 4}, .direction = {0, 1, -1}}, right_angled, 2));
    CHECK(hits(Ray{.origin = {0, 6, 2}, .direction = {0, -1, -1}}, right_angled, 4));
    CHECK(misses(Ray{.origin = {0, 0, -4}, .direction = {0, 1, -1}}, right_angled));
    CHECK(misses(Ray{.origin = {0, 0, 9}, .direction = {0, 1, -1}}, right_angled));
    CHECK(for_all([](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const Vec3 point = cone.apex + random.eighths(1, 3) * (x + y);
        const Real t = random.eighths(1, 32);
        return hits({.origin = point - t * (y - x), .direction = y - x}, cone, t);
    }));
}

TEST_CASE("a ray almost parallel to a line of the side hits it (MRT §8)", "[exact]") {
    const Real slope = std::ldexp(Real(1), -10);
    // Direction (0, 1, −(1 − s)): z = 4 − (1 − s) t meets y = t at t = 4 / (2 − s).
    CHECK(hits(Ray{.origin = {0, 0, 4}, .direction = {0, 1, -(1 - slope)}}, right_angled,
               4 / (2 - slope)));
    CHECK(for_all([slope](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const Real away = random.eighths(1, 7);
        return hits({.origin = cone.apex + away * x, .direction = y - (1 - slope) * x}, cone,
                    away / (2 - slope));
    }));
    // Nearer to it the textbook's root is a small difference. A few digits of it are left, and only
    // these are tested, in a few cases.
    const Real almost = std::ldexp(Real(1), is_float ? -16 : -41);
    CHECK(for_all(
        [almost](Random& random) {
            const auto [cone, x, y] = draw_in_eighths(random);
            const Real away = random.eighths(1, 7);
            const Ray ray{.origin = cone.apex + away * x, .direction = y - (1 - almost) * x};
            const std::optional<Real> t = intersect(ray, cone, {});
            return verdict(t && std::abs(*t - away / 2) < away / 32,
                           intersection_report(ray, cone, {}, t, away / 2));
        },
        20));
}

TEST_CASE("a ray parallel to the axis, beside it, hits the side (MRT §8)") {
    // Straight down beside the axis, into the cone: out of the open top, onto the inside.
    CHECK(hits(Ray{.origin = {1, 9, 0}, .direction = {0, -1, 0}}, upward, 7));
    CHECK(hits(Ray{.origin = {1, -5, 0}, .direction = {0, 1, 0}}, upward, 7));
    CHECK(hits(Ray{.origin = {1, 3, 0}, .direction = {0, -1, 0}}, upward, 1));
    CHECK(misses(Ray{.origin = {1, 3, 0}, .direction = {0, 1, 0}}, upward));
}

TEST_CASE("a ray along the axis hits the apex or misses (MRT §8)", "[exact]") {
    // A double root: some right formulas just miss it.
    const std::optional<Real> t = intersect({{0, 9, 0}, {0, -1, 0}}, upward, {});
    CHECK(verdict(!t || close(*t, 9), "Expected the apex at t = 9, or nothing: " + got_text(t)));
    CHECK(misses(Ray{.origin = {0, 2, 0}, .direction = {0, 1, 0}}, upward));
}

TEST_CASE("a ray tangent to the side, or through the apex, hits it (PHY, B² − 4AC = 0; 0 ≤ z_p)",
          "[exact]") {
    // In the plane z = y, which touches the side along (0, 1, 1).
    CHECK(hits(Ray{.origin = {-5, 2, 2}, .direction = {1, 0, 0}}, right_angled, 5));
    CHECK(hits(Ray{.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, right_angled, 5));
    CHECK(for_all([](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const Vec3 touched = cone.apex + random.eighths(0, 3) * (x + y);
        const Vec3 along = cross(x, y);
        const Real t = random.eighths(1, 32);
        return hits({.origin = touched - t * along, .direction = along}, cone, t);
    }));
    CHECK(for_all(hits_almost_touching));
}

TEST_CASE("rays to the rim hit, rays just outside it miss (MRT §8, z_p ≤ h)", "[exact]") {
    CHECK(hits(Ray{.origin = {0, 4, 5}, .direction = {0, 0, -1}}, upward, 3));
    CHECK(for_all([](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const Vec3 rim = cone.apex + cone.height * (x + y);
        const Real t = random.eighths(1, 32);
        if (random.coin())  // from inside
            return hits({.origin = cone.apex + cone.height * y, .direction = x}, cone, cone.radius);
        return hits({.origin = rim + t * x, .direction = -x}, cone, t);
    }));
    // A hair beyond it, and a hair before it.
    CHECK(for_all([](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const bool inside = random.coin();
        const Real z = (inside ? 1 - hair : 1 + hair) * cone.height;
        const Vec3 on_axis = cone.apex + z * y;
        const Real t = random.eighths(1, 9);
        const bool from_axis = random.coin();
        const Ray ray = from_axis ? Ray{.origin = on_axis, .direction = x}
                                  : Ray{.origin = on_axis + (z + t) * x, .direction = -x};
        return inside ? hits(ray, cone, from_axis ? z : t) : misses(ray, cone);
    }));
}

TEST_CASE("a ray over the rim hits the far inside, for any direction of the axis (MRT §8)") {
    CHECK(for_all([](Random& random) {
        const Real passed = random.between(Real(1.1), Real(1.5));
        return hits_behind(passed, random);
    }));
}

TEST_CASE("a ray from inside hits the side (MRT §8, PHY)") {
    CHECK(hits(Ray{.origin = {0, 2, 0}, .direction = {0, 0, -1}}, upward, 1));
    CHECK(misses(Ray{.origin = {0, 3, 0}, .direction = {0, 2, -1}}, upward));
    CHECK(for_all([](Random& random) {
        const Sample<Cone> sample = draw(random);
        const auto& [apex, axis, radius, height] = sample.shape;
        const Real z = random.between(Real(0.5), Real(1.6)) * dot(sample.point - apex, axis);
        const Vec3 origin = apex + z * axis;
        return hits({.origin = origin, .direction = sample.point - origin}, sample.shape, 1);
    }));
}

TEST_CASE(
    "a ray from a point of the side: out of it a miss, into it a hit of the far side (PHY, t > "
    "0)") {
    const Interval beyond{.min = Real(0.001), .max = infinity};
    CHECK(misses(Ray{.origin = {0, 2, 1}, .direction = {0, 0, 1}}, upward, beyond));
    CHECK(hits(Ray{.origin = {0, 2, 1}, .direction = {0, 0, -1}}, upward, 2, beyond));
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -4}}, upward, 1));
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, Real(-0.25)}}, upward, 16));
}

TEST_CASE("only hits strictly inside the interval count (contract)") {
    const Ray ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}};
    CHECK(hits(ray, upward, 6, Interval{.min = Real(4.1), .max = infinity}));
    CHECK(misses(ray, upward, Interval{.min = Real(4.1), .max = Real(5.9)}));
    CHECK(misses(ray, upward, Interval{.min = 0, .max = Real(3.9)}));
    const Ray from_inside{.origin = {0, 2, 0}, .direction = {0, 0, -1}};
    CHECK(misses(from_inside, upward, Interval{.min = 0, .max = Real(0.9)}));
    CHECK(misses(from_inside, upward, Interval{.min = Real(1.1), .max = 9}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (contract)") {
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_cone, draw));
    CHECK(far_shapes_are_hit(draw));
    CHECK(close_surfaces_are_hit(draw));
    CHECK(for_all([](Random& random) {  // a hair outside, and a hair inside
        const auto [cone, x, y] = draw_in_eighths(random);
        const Real z = Real(1 << random.below(3));
        const bool outside = random.coin();
        const Real share = outside ? 1 + hair : 1 - hair;
        return hits({cone.apex + z * (y + share * x), outside ? -x : x}, cone, hair * z);
    }));
}

TEST_CASE("very small cones and very short directions (contract)") {
    CHECK(hits_in(small_cone, draw));
    CHECK(hits_in(short_direction, draw));
    CHECK(misses_in(small_cone, draw_past));
    CHECK(misses_in(short_direction, draw_past));
    CHECK(for_all([](Random& random) {  // flat, or steep
        auto [cone, x, y] = draw_in_eighths(random);
        (random.coin() ? cone.height : cone.radius) *= std::ldexp(Real(1), -4 - random.below(5));
        const Real t = random.eighths(1, 32);
        return hits({cone.apex + cone.height / 2 * y + (cone.radius / 2 + t) * x, -x}, cone, t);
    }));
}

TEST_CASE("rays aimed at a point of the side hit it there (MRT §8)") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("rays aimed past the side miss (MRT §8)") {
    CHECK(misses_in({}, draw_past));
}

TEST_CASE("rays aimed 0.1 % beyond the rim miss (MRT §8)") {
    CHECK(for_all([](Random& random) {
        const Real margin = draw_narrow(random);
        if (random.coin()) return hits_behind(1 + margin, random);
        const Sample<Cone> sample = draw_at(1 - margin, random);
        const auto aimed = aimed_from_outside(sample, random);
        return hits(aimed.ray, aimed.shape, aimed.t);
    }));
    CHECK(for_all(ends_at_its_rim));
    CHECK(for_all(ends_at_its_apex));
}

TEST_CASE("the normal on the side and at the rim (MRT §8)", "[part normal]") {
    const Real half = std::sqrt(Real(0.5));
    CHECK(normal_is(right_angled, {0, 2, 2}, {0, -half, half}));
    CHECK(normal_is(right_angled, {-3, 3, 0}, {-half, -half, 0}));
    CHECK(normal_is(upward, {0, 2, 1}, Vec3(0, -1, 2) / std::sqrt(Real(5))));
    CHECK(normals_point_outward(draw));
    CHECK(for_all([](Random& random) {  // at the rim too
        const Sample<Cone> rim = draw_at(1, random);
        return normal_is(rim.shape, rim.point, rim.normal);
    }));
}

TEST_CASE("the normal on the side near the apex (contract)", "[exact]") {
    const Real half = std::sqrt(Real(0.5));
    for (const int power : {-7, -12, -20}) {
        const Real near = std::ldexp(Real(1), power);
        CHECK(normal_is(right_angled, {0, near, near}, {0, -half, half}));
    }
    CHECK(for_all([half](Random& random) {
        const auto [cone, x, y] = draw_in_eighths(random);
        const Real near = random.eighths(1, 2) * std::ldexp(Real(1), -7 - random.below(6));
        return normal_is(cone, cone.apex + near * (x + y), half * (x - y));
    }));
}

TEST_CASE("at the apex the normal is -axis (contract)") {
    CHECK(normal_is(upward, {0, 0, 0}, {0, -1, 0}));
    CHECK(for_all([](Random& random) {
        const Cone cone = draw_cone(random, random.direction());
        return normal_is(cone, cone.apex, -cone.axis);
    }));
}

TEST_CASE("X and Y are at right angles to Z, however near it is to the vertical (MRT §8)",
          "[part together]") {
    CHECK(aimed_rays_hit(draw_upright));
    CHECK(normals_point_outward(draw_upright));
}

TEST_CASE("a hit is the same hit after everything has moved, turned and grown (HAI)") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("a ray or shape with NaN is a miss (contract)") {
    CHECK(nan_misses(draw));
}

TEST_CASE("the picture of the stage (MRT §8)") {
    CHECK(picture_matches("step08_cone"));
}
