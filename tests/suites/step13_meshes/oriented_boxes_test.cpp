// Boxes with a basis, against M1.
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/shape_checks.hpp"
#include "tests/kit/units.hpp"

#include <array>

using namespace rt;

namespace {

/// Around (0, 0, -5), half as wide, high and deep as 2, 4, 6; along the axes.
const OrientedBox upright{.center = {0, 0, -5}, .half_size = {1, 2, 3}};

/// A point of a face: at most 0.9 of the way to an edge, or beside one, less than a thousandth of
/// the size away from another face.
Sample<OrientedBox> draw_on_face(Random& random, bool beside_an_edge) {
    const Basis basis = draw_basis(random);
    const Vec3 half_size = Vec3(Real(0.5)) + abs(random.point(1));
    const std::array<Vec3, 3> axes = {basis.x, basis.y, basis.z};
    const auto face = glm::length_t(random.below(3));
    const Real sign = random.coin() ? 1 : -1;
    Vec3 share = random.point(Real(0.9));
    share[face] = sign;
    if (beside_an_edge) {
        const auto other = (face + 1 + random.below(2)) % 3;
        share[other] = (random.coin() ? 1 : -1) * (1 - draw_narrow(random));
    }
    const OrientedBox box{.center = random.point(3), .basis = basis, .half_size = half_size};
    const Vec3 p = share * half_size;
    return {.shape = box,
            .point = box.center + p.x * basis.x + p.y * basis.y + p.z * basis.z,
            .normal = sign * axes[std::size_t(face)]};
}

Sample<OrientedBox> draw_box(Random& random) {
    return draw_on_face(random, false);
}

Sample<OrientedBox> draw_beside_an_edge(Random& random) {
    return draw_on_face(random, true);
}

/// In eighths, along the axes, half sizes powers of two from 1: with rays along or across them
/// nothing is rounded.
OrientedBox draw_box_in_eighths(Random& random) {
    return {.center = random.point_in_eighths(3),
            .basis = random.axes(),
            .half_size = Vec3(1 << random.below(3), 1 << random.below(3), 1 << random.below(3))};
}

}  // namespace

TEST_CASE("a ray hits the near face of an oriented box (M1)",
          "[part oriented boxes (intersect with an oriented box, normal)]") {
    CHECK(hits(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {5, 0, -5}, .direction = {-1, 0, 0}}, upright, 4));
    CHECK(hits(Ray{.origin = {0, -6, -5}, .direction = {0, 2, 0}}, upright, 2));
    CHECK(hits(Ray{.origin = {Real(0.9), Real(1.9), 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(misses(Ray{.origin = {Real(1.1), 0, 0}, .direction = {0, 0, -1}}, upright));
    CHECK(misses(Ray{.origin = {0, Real(2.1), 0}, .direction = {0, 0, -1}}, upright));
}

TEST_CASE("an oriented box turns with its basis (M1)") {
    // Its x axis is the scene's y, its y axis the scene's -x.
    OrientedBox rotated = upright;
    rotated.basis = {.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    CHECK(hits(Ray{.origin = {Real(1.9), 0, 0}, .direction = {0, 0, -1}}, rotated, 2));
    CHECK(misses(Ray{.origin = {0, Real(1.1), 0}, .direction = {0, 0, -1}}, rotated));
    // Round z by the angle of 3, 4, 5: along (0.8, 0.6) it reaches to 1, along (-0.6, 0.8) to 2.
    const Real s = Real(0.6);
    const Real c = Real(0.8);
    rotated.basis = {.x = {c, s, 0}, .y = {-s, c, 0}, .z = {0, 0, 1}};
    CHECK(hits(Ray{.origin = {5 * c, 5 * s, -5}, .direction = {-c, -s, 0}}, rotated, 4));
    CHECK(hits(Ray{.origin = {-5 * s, 5 * c, -5}, .direction = {s, -c, 0}}, rotated, 3));
    const Vec3 near_corner = Real(0.9) * rotated.basis.x + Real(1.9) * rotated.basis.y;
    const Vec3 past_corner = Real(0.9) * rotated.basis.x + Real(2.1) * rotated.basis.y;
    CHECK(hits(Ray{.origin = near_corner, .direction = {0, 0, -1}}, rotated, 2));
    CHECK(misses(Ray{.origin = past_corner, .direction = {0, 0, -1}}, rotated));
}

TEST_CASE("rays aimed at a point of an oriented box hit it there (M1)") {
    CHECK(aimed_rays_hit(draw_box));
}

TEST_CASE("rays aimed past an oriented box miss (M1)") {
    CHECK(for_all([](Random& random) {
        const Sample<OrientedBox> sample = draw_box(random);
        Vec3 along = cross(sample.normal, random.direction());
        if (along == Vec3(0)) along = cross(sample.normal, Vec3(1, 2, 3));
        const Vec3 passed = sample.point + random.between(Real(0.01), 1) * sample.normal;
        return misses({.origin = passed - Real(4) * unit(along), .direction = along}, sample.shape);
    }));
}

TEST_CASE("a ray from inside an oriented box hits it where it leaves (M1)") {
    CHECK(hits(Ray{.origin = {0, 0, -5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(hits(Ray{.origin = {0, 1, -5}, .direction = {0, 1, 0}}, upright, 1));
    CHECK(for_all([](Random& random) {
        const Sample<OrientedBox> sample = draw_box(random);
        const auto& [x, y, z] = sample.shape.basis;
        const Vec3 p = random.point(Real(0.5)) * sample.shape.half_size;
        const Vec3 origin = sample.shape.center + p.x * x + p.y * y + p.z * z;
        return hits({.origin = origin, .direction = sample.point - origin}, sample.shape, 1);
    }));
}

TEST_CASE("an oriented box behind the eye is missed (erratum 8, M1)") {
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}}, upright));
    CHECK(nothing_behind_is_hit(draw_box));
}

TEST_CASE("a ray along a face, into an edge or touching an edge hits the box (M1)", "[exact]") {
    CHECK(hits(Ray{.origin = {1, 0, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {0, -2, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {3, 0, 0}, .direction = {-1, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {-1, 0, 0}, .direction = {1, 0, -1}}, upright, 2));
    CHECK(for_all([](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 edge =
            box.center + box.half_size.x * x + random.eighths(-1, 1) * y + box.half_size.z * z;
        const std::array directions{-z, -x - z, x - z};  // along, into, past
        const Vec3 direction = directions[std::size_t(random.below(3))];
        const Real t = random.eighths(1, 32);
        return hits({.origin = edge - t * direction, .direction = direction}, box, t);
    }));
}

TEST_CASE("an oriented box is hit at very small t (erratum 31, contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {0, 0, near - 2}, .direction = {0, 0, -1}}, upright, near));
    CHECK(hits(Ray{.origin = {0, 0, 1}, .direction = {0, 0, -3 / near}}, upright, near));
    CHECK(for_all([near](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 point = box.center + random.eighths(-1, 1) * x + box.half_size.z * z;
        const Real t = random.eighths(1, 32);
        return hits({.origin = point + t * z, .direction = -t / near * z}, box, near);
    }));
    // Boxes and directions of any size.
    CHECK(hits_in(tiny_t, draw_box));
    CHECK(hits_in(tiny_shape, draw_box));
    CHECK(hits_in(short_direction, draw_box));
    CHECK(close_surfaces_are_hit(draw_box));
}

TEST_CASE(
    "a ray from a point of a face: out of it a miss, into it a hit of the far side (PHY, t > 0)",
    "[exact]") {
    CHECK(misses(Ray{.origin = {0, 0, -2}, .direction = {0, 0, 1}}, upright));
    CHECK(hits(Ray{.origin = {0, 0, -2}, .direction = {0, 0, -1}}, upright, 6));
    CHECK(for_all([](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 origin = box.center + random.eighths(-1, 1) * x / Real(2) + box.half_size.z * z;
        if (random.coin()) return misses({.origin = origin, .direction = z}, box);
        return hits({.origin = origin, .direction = -z}, box, 2 * box.half_size.z);
    }));
}

TEST_CASE("only faces strictly inside the interval are hit (contract)", "[exact]") {
    const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(hits(ray, upright, 8, Interval{.min = 3, .max = infinity}));
    CHECK(misses(ray, upright, Interval{.min = 3, .max = 7}));
    CHECK(misses(ray, upright, Interval{.min = 0, .max = 2}));
    // From inside, where the ray leaves the box 3 ahead.
    const Ray out{.origin = {0, 0, -5}, .direction = {0, 0, -1}};
    CHECK(misses(out, upright, Interval{.min = 0, .max = 2}));
    CHECK(misses(out, upright, Interval{.min = 4, .max = 9}));
    CHECK(interval_is_kept(draw_box));
}

TEST_CASE("the normal of each face of boxes of any sizes (M1)") {
    CHECK(normal_is(upright, {1, Real(1.5), -5}, {1, 0, 0}));
    CHECK(normal_is(upright, {-1, Real(1.5), Real(-7.5)}, {-1, 0, 0}));
    CHECK(normal_is(upright, {Real(0.5), 2, Real(-7.5)}, {0, 1, 0}));
    CHECK(normal_is(upright, {Real(0.5), -2, -5}, {0, -1, 0}));
    CHECK(normal_is(upright, {0, 0, -8}, {0, 0, -1}));
    // Close to an edge: less than a thousandth of the size away from the other face.
    const Real beside = 1 - std::ldexp(Real(1), -11);
    CHECK(normal_is(upright, {beside, 2, -5}, {0, 1, 0}));
    CHECK(normal_is(upright, {1, 2 * beside, -5}, {1, 0, 0}));
    CHECK(normals_point_outward(draw_beside_an_edge));
    CHECK(normals_point_outward(draw_box));
    // However small the box is.
    CHECK(for_all([](Random& random) {
        const Transform tiny{.scale = std::ldexp(Real(1), tiny_shape.size)};
        const auto [box, point, normal] = draw_box(random);
        return normal_is(transformed(box, tiny), transformed(point, tiny), normal);
    }));
}

TEST_CASE("a box is the same box after everything has moved, turned and grown (HAI)") {
    CHECK(motion_changes_nothing(draw_box));
}

TEST_CASE("with a coordinate that is not a number, a ray misses an oriented box (contract)") {
    CHECK(nan_misses(draw_box));
}
