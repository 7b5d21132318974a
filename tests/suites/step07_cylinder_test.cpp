// Stage 7 against MRT §7.
#include "steps/step07_cylinder/cylinder.hpp"

#include "tests/kit/nearly_vertical.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

using namespace rt;

namespace {

/// Upright, radius 2, from y = -3 to y = 3.
const Cylinder upright{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 2, .height = 6};

Cylinder draw_cylinder(Random& random) {
    return {.center = random.point(3),
            .axis = random.direction(),
            .radius = random.between(Real(0.5), 1),
            .height = random.between(1, 3)};
}

/// At most 0.9 of the way to a rim: rounding does not decide what is within the height.
Sample<Cylinder> draw(Random& random) {
    const Basis basis = draw_basis(random);
    Cylinder cylinder = draw_cylinder(random);
    cylinder.axis = basis.z;
    const Real z = random.between(Real(-0.45), Real(0.45)) * cylinder.height;
    return {.shape = cylinder,
            .point = cylinder.center + z * basis.z + cylinder.radius * basis.x,
            .normal = basis.x};
}

/// At right angles to the axis and to the normal, outside: nothing is nearer.
Past<Cylinder> draw_past(Random& random) {
    const Sample<Cylinder> sample = draw(random);
    const Vec3 along = cross(sample.shape.axis, sample.normal);
    const Vec3 passed = sample.point + draw_gap(random) * sample.shape.radius * sample.normal;
    const Real back = random.between(-4, 4);
    return {.ray = {.origin = passed - back * along, .direction = along}, .shape = sample.shape};
}

/// As `draw_past`, but through the inside, close to the surface.
Verdict hits_almost_touching(Random& random) {
    const auto [cylinder, point, normal] = draw(random);
    const Vec3 along = cross(cylinder.axis, normal);
    const Real depth = draw_gap(random) / 2 * cylinder.radius;
    const Real half_chord = std::sqrt(depth * (2 * cylinder.radius - depth));
    const Real back = random.between(2, 4);
    const Ray ray{.origin = point - depth * normal - back * along, .direction = along};
    const std::optional<Real> t = intersect(ray, cylinder, {});
    const Real near = back - half_chord;
    return verdict(t && std::abs(*t - near) < half_chord / 8,
                   intersection_report(ray, cylinder, {}, t, near));
}

/// From outside and across, at a point of the endless tube this many half heights from the center.
Aimed<Cylinder> aimed_at_height(Real halves, Random& random) {
    Sample<Cylinder> sample = draw(random);
    const auto& [center, axis, radius, height] = sample.shape;
    const Real z = (random.coin() ? -1 : 1) * halves * height / 2;
    sample.point = center + z * axis + radius * sample.normal;
    const Real back = random.between(1, 4);
    return {.ray = {.origin = sample.point + back * sample.normal, .direction = -sample.normal},
            .shape = sample.shape,
            .t = back,
            .point = sample.point,
            .normal = sample.normal};
}

/// A ray at up to 45° to a rim, from outside or from inside, where it may come through the open
/// end, hits the side a little before the rim, or misses a little beyond it. A small cylinder near
/// the world's origin: in float a textbook's formula has z to 10^-5 there, and the margin is
/// 9·10^-5.
Verdict ends_at_its_rims(Random& random) {
    constexpr Real margin = Real(0x1p-14);
    const Basis basis = random.basis();
    const Cylinder cylinder{.center = random.point(Real(0.25)),
                            .axis = basis.z,
                            .radius = random.between(Real(0.5), 1),
                            .height = random.between(3, 4)};
    const bool inside = random.coin();
    const Vec3 to_rim = random.coin() ? basis.z : -basis.z;
    const Real z = (inside ? 1 - margin : 1 + margin) * cylinder.height / 2;
    const Vec3 point = cylinder.center + z * to_rim + cylinder.radius * basis.x;
    const Real t = random.between(Real(0.5), 1) * cylinder.radius;
    const bool outwards = random.coin();
    // Beyond the rim and inwards, it leads away from the cylinder: another hit is not possible.
    const Real slope = random.between(outwards || inside ? -1 : 0, 1);
    const Vec3 direction = (outwards ? basis.x : -basis.x) + slope * to_rim;
    const Ray ray{.origin = point - t * direction, .direction = direction};
    return inside ? hits(ray, cylinder, t) : misses(ray, cylinder);
}

Past<Cylinder> draw_past_rim(Random& random) {
    const auto aimed = aimed_at_height(random.between(Real(1.1), 3), random);
    return {.ray = aimed.ray, .shape = aimed.shape};
}

/// As `draw`, but long, and almost or exactly upright.
Sample<Cylinder> draw_upright(Random& random) {
    const Basis basis = nearly_vertical_basis(random);
    Cylinder cylinder = draw_cylinder(random);
    cylinder.axis = basis.z;
    cylinder.height = random.between(4, 8);
    const Real z = random.between(Real(-0.45), Real(0.45)) * cylinder.height;
    return {.shape = cylinder,
            .point = cylinder.center + z * basis.z + cylinder.radius * basis.x,
            .normal = basis.x};
}

struct Across {
    Cylinder cylinder;
    Vec3 x;  ///< at right angles to the axis
    Vec3 y;  ///< the axis
};

/// In eighths, along the axes, the radius a power of two: with rays along x, y and across both,
/// nothing is rounded.
Across draw_in_eighths(Random& random) {
    const auto [x, y, z] = random.axes();
    return {.cylinder = {.center = random.point_in_eighths(3),
                         .axis = y,
                         .radius = Real(1 << random.below(3)),
                         .height = 2 * random.eighths(1, 3)},
            .x = x,
            .y = y};
}

/// A ray almost along the axis hits at t. A formula in which a cancels loses this hit, and so does
/// an epsilon.
Verdict hits_steeply(const Ray& ray, const Cylinder& cylinder, Real t) {
    Verdict hit = hits(ray, cylinder, t);
    if (!hit)
        hit.sentence +=
            "\n  Is there an epsilon on a? If not, is a the difference ⟨d, d⟩ − ⟨d, Z⟩², or"
            "\n  1 − ⟨d, Z⟩²? Of two almost equal numbers only rounding errors are left, or 0:"
            "\n  compute a from d ∧ Z, or from d − ⟨d, Z⟩ Z.";
    return hit;
}

}  // namespace

TEST_CASE("a ray across the cylinder hits the near side (MRT §7)",
          "[part intersect][3 points][exact]") {
    CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(hits(Ray{.origin = {-7, 1, 0}, .direction = {1, 0, 0}}, upright, 5));
    CHECK(hits(Ray{.origin = {0, 5, 5}, .direction = {0, -1, -1}}, upright, 3));
    CHECK(misses(Ray{.origin = {3, 0, 5}, .direction = {0, 0, -1}}, upright));
    CHECK(for_all([](Random& random) {
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const Vec3 near = cylinder.center + random.eighths(0, 1) / 2 * y + cylinder.radius * x;
        const Real t = random.eighths(1, 9);
        return hits({.origin = near + t * x, .direction = -x}, cylinder, t);
    }));
}

TEST_CASE("rays just inside and just outside both ends of the cylinder (MRT §7)") {
    CHECK(hits(Ray{.origin = {0, Real(2.75), 5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(hits(Ray{.origin = {0, Real(-2.75), 5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(misses(Ray{.origin = {0, Real(3.25), 5}, .direction = {0, 0, -1}}, upright));
    CHECK(misses(Ray{.origin = {0, Real(-3.25), 5}, .direction = {0, 0, -1}}, upright));
    const Cylinder transformed{.center = {10, 4, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2};
    CHECK(hits(Ray{.origin = {10, Real(4.5), 5}, .direction = {0, 0, -1}}, transformed, 4));
    CHECK(misses(Ray{.origin = {10, Real(5.5), 5}, .direction = {0, 0, -1}}, transformed));
}

TEST_CASE("cylinders along x and z (MRT §7)") {
    const Cylinder along_x{.center = {0, 0, 0}, .axis = {1, 0, 0}, .radius = 1, .height = 4};
    const Cylinder along_z{.center = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 4};
    CHECK(hits(Ray{.origin = {Real(1.5), 5, 0}, .direction = {0, -1, 0}}, along_x, 4));
    CHECK(misses(Ray{.origin = {Real(2.5), 5, 0}, .direction = {0, -1, 0}}, along_x));
    CHECK(hits(Ray{.origin = {0, 5, Real(-1.5)}, .direction = {0, -1, 0}}, along_z, 4));
    CHECK(misses(Ray{.origin = {0, 5, Real(-2.5)}, .direction = {0, -1, 0}}, along_z));
}

TEST_CASE("a cylinder with the opposite axis is the same cylinder (MRT §7)") {
    Cylinder rotated = upright;
    rotated.axis = {0, -1, 0};
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, rotated, 3));
    CHECK(hits(Ray{.origin = {0, -2, 5}, .direction = {0, 0, -1}}, rotated, 3));
}

TEST_CASE("rays to both rims hit, rays just outside them miss (MRT §7)", "[exact]") {
    CHECK(hits(Ray{.origin = {0, 3, 5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(hits(Ray{.origin = {0, -3, 5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(for_all([](Random& random) {
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const Vec3 rim = cylinder.center + (random.coin() ? -1 : 1) * cylinder.height / 2 * y;
        const Real t = random.eighths(1, 32);
        if (random.coin())  // from inside
            return hits({.origin = rim, .direction = x}, cylinder, cylinder.radius);
        return hits({.origin = rim + (cylinder.radius + t) * x, .direction = -x}, cylinder, t);
    }));
    // A hair beyond it, and a hair before it.
    CHECK(for_all([](Random& random) {
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const bool inside = random.coin();
        const Real z = (inside ? 1 - hair : 1 + hair) * cylinder.height / 2;
        const Real t = random.eighths(1, 9);
        const Vec3 on_axis = cylinder.center + (random.coin() ? -z : z) * y;
        const Vec3 point = on_axis + cylinder.radius * x;
        const bool from_axis = random.coin();
        const Ray ray = from_axis ? Ray{.origin = on_axis, .direction = x}
                                  : Ray{.origin = point + t * x, .direction = -x};
        return inside ? hits(ray, cylinder, from_axis ? cylinder.radius : t)
                      : misses(ray, cylinder);
    }));
}

TEST_CASE("a shape behind the origin is a miss (PHY, t positive)") {
    CHECK(misses(Ray{.origin = {0, 0, 5}, .direction = {0, 0, 1}}, upright));
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("a ray along the axis misses (erratum 6, MRT §7)", "[exact]") {
    CHECK(misses(Ray{.origin = {0, 9, 0}, .direction = {0, -1, 0}}, upright));
    CHECK(misses(Ray{.origin = {1, 0, 1}, .direction = {0, 1, 0}}, upright));
    CHECK(misses(Ray{.origin = {3, 0, 0}, .direction = {0, 1, 0}}, upright));
    CHECK(misses(Ray{.origin = {2, 0, 0}, .direction = {0, 1, 0}}, upright));
}

TEST_CASE("rays in at one end and out at the other miss (MRT §7)") {
    // In through the top, out through the bottom, never near the side.
    CHECK(misses(Ray{.origin = {1, 9, 0}, .direction = {Real(-0.0625), -1, 0}}, upright));
    CHECK(misses(Ray{.origin = {-1, 8, 0}, .direction = {1, -8, 0}}, upright));
}

TEST_CASE("a ray into an open end hits the far inside (MRT §7)") {
    // At t = 1 it passes over the near side at y = 4, above the rim. At t = 5 it hits the far one.
    CHECK(hits(Ray{.origin = {0, 5, 3}, .direction = {0, -1, -1}}, upright, 5));
    CHECK(hits(Ray{.origin = {0, -5, 3}, .direction = {0, 1, -1}}, upright, 5));
    CHECK(hits(Ray{.origin = {-5, 8, 0}, .direction = {1, -1, 0}}, upright, 7));
}

TEST_CASE("a ray almost along the axis hits the side (MRT §7)", "[exact]") {
    const Real slope = std::ldexp(Real(1), -24);
    const Cylinder narrow{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 2 * slope, .height = 6};
    CHECK(hits_steeply(Ray{.origin = {0, 0, 0}, .direction = {slope, 1, 0}}, narrow, 2));
    CHECK(for_all([slope](Random& random) {
        const Real t = random.eighths(1, 2);
        const Cylinder thin{.center = {0, 0, 0},
                            .axis = {0, 1, 0},
                            .radius = t * slope,
                            .height = random.eighths(6, 9)};
        const Real up = random.eighths(-3, 1);
        return hits_steeply(Ray{.origin = {0, up, 0}, .direction = {slope, 1, 0}}, thin, t);
    }));
}

TEST_CASE("a ray from inside hits the side (MRT §7, PHY)") {
    CHECK(hits(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {1, 0, 0}, .direction = {-1, 0, 0}}, upright, 3));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {0, 2, -1}}, upright));
    CHECK(for_all([](Random& random) {
        const Sample<Cylinder> sample = draw(random);
        const auto& [center, axis, radius, height] = sample.shape;
        // From the axis: no nearer than 45° to it, or the hit is ill-conditioned.
        const Real z = dot(sample.point - center, axis) + random.between(-radius, radius);
        const Vec3 origin = center + z * axis;
        return hits({.origin = origin, .direction = sample.point - origin}, sample.shape, 1);
    }));
}

TEST_CASE("a ray tangent to the side hits it (PHY, B² − 4AC = 0)", "[exact]") {
    CHECK(hits(Ray{.origin = {2, 1, 5}, .direction = {0, 0, -1}}, upright, 5));
    CHECK(for_all([](Random& random) {
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const Vec3 touched = cylinder.center + random.eighths(-1, 1) * y + cylinder.radius * x;
        const Vec3 along = cross(x, y);
        const Real t = random.eighths(1, 32);
        return hits({.origin = touched - t * along, .direction = along}, cylinder, t);
    }));
    CHECK(for_all(hits_almost_touching));
}

TEST_CASE(
    "a ray from a point of the side: out of it a miss, into it a hit of the far side (PHY, t > 0)",
    "[exact]") {
    CHECK(misses(Ray{.origin = {0, 0, 2}, .direction = {0, 0, 1}}, upright));
    CHECK(hits(Ray{.origin = {0, 0, 2}, .direction = {0, 0, -1}}, upright, 4));
    CHECK(for_all([](Random& random) {
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const Vec3 origin = cylinder.center + random.eighths(-1, 1) * y + cylinder.radius * x;
        if (random.coin()) return misses({.origin = origin, .direction = x}, cylinder);
        return hits({.origin = origin, .direction = -x}, cylinder, 2 * cylinder.radius);
    }));
}

TEST_CASE("t counts in the length of the direction (PHY, any v)") {
    CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -4}}, upright, Real(0.75)));
    CHECK(hits(Ray{.origin = {0, 0, 5}, .direction = {0, 0, Real(-0.25)}}, upright, 12));
}

TEST_CASE("only hits strictly inside the interval count (contract)", "[exact]") {
    const Ray ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    CHECK(hits(ray, upright, 7, Interval{.min = 3, .max = infinity}));
    CHECK(misses(ray, upright, Interval{.min = 3, .max = 7}));
    CHECK(misses(ray, upright, Interval{.min = 0, .max = 3}));
    const Ray from_inside{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(misses(from_inside, upright, Interval{.min = 0, .max = 2}));
    CHECK(misses(from_inside, upright, Interval{.min = 2, .max = 9}));
    CHECK(interval_is_kept(draw));
}

TEST_CASE("hits at very small and very large t (contract)") {
    CHECK(hits_in(tiny_t, draw));
    CHECK(hits_in(huge_shape, draw));
    CHECK(far_shapes_are_hit(draw));
    CHECK(close_surfaces_are_hit(draw));
    CHECK(for_all([](Random& random) {  // a hair outside, and a hair inside
        const auto [cylinder, x, y] = draw_in_eighths(random);
        const bool outside = random.coin();
        const Real share = outside ? 1 + hair : 1 - hair;
        const Vec3 origin = cylinder.center + share * cylinder.radius * x;
        return hits({.origin = origin, .direction = outside ? -x : x}, cylinder,
                    hair * cylinder.radius);
    }));
}

TEST_CASE("very small cylinders and very short directions (contract)") {
    CHECK(hits_in(tiny_shape, draw));
    CHECK(hits_in(short_direction, draw));
    CHECK(misses_in(tiny_shape, draw_past));
    CHECK(misses_in(tiny_shape, draw_past_rim));
    CHECK(misses_in(short_direction, draw_past));
    CHECK(for_all([](Random& random) {  // flat, or thin
        auto [cylinder, x, y] = draw_in_eighths(random);
        if (random.coin())
            cylinder.height *= std::ldexp(Real(1), -4 - random.below(9));
        else
            cylinder.radius *= std::ldexp(Real(1), -4 - random.below(5));
        const Real t = random.eighths(1, 32);
        return hits({cylinder.center + (cylinder.radius + t) * x, -x}, cylinder, t);
    }));
}

TEST_CASE("rays aimed at a point of the side hit it there (MRT §7)") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("rays aimed past the side miss (MRT §7)") {
    CHECK(misses_in({}, draw_past));
    CHECK(misses_in({}, draw_past_rim));
}

TEST_CASE("rays aimed 0.1 % beyond the rims miss (MRT §7)") {
    CHECK(for_all([](Random& random) {
        const Real margin = draw_narrow(random);
        const bool inside = random.coin();
        const auto aimed = aimed_at_height(inside ? 1 - margin : 1 + margin, random);
        return inside ? hits(aimed.ray, aimed.shape, aimed.t) : misses(aimed.ray, aimed.shape);
    }));
    CHECK(for_all(ends_at_its_rims));
}

TEST_CASE("the normal points away from the axis, with unit length (MRT §7)", "[part normal]") {
    CHECK(normal_is(upright, {0, 2, 2}, {0, 0, 1}));
    CHECK(normal_is(upright, {-2, -1, 0}, {-1, 0, 0}));
    CHECK(normals_point_outward(draw));
    CHECK(for_all([](Random& random) {  // at the rims too
        const auto rim = aimed_at_height(1, random);
        return normal_is(rim.shape, rim.point, rim.normal);
    }));
}

TEST_CASE("X and Y are at right angles to Z, however near it is to the vertical (MRT §7)",
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

TEST_CASE("the picture of the stage (MRT §7)") {
    CHECK(picture_matches("step07_cylinder"));
}
