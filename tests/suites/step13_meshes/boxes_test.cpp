// Boxes along the axes, and boxes with a basis, against M1.
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/shape_checks.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

// Boxes along the axes.

/// From (-1, -2, -3) to (1, 2, 3).
const BoundingBox block{.min = {-1, -2, -3}, .max = {1, 2, 3}};

std::string got_text(const std::optional<Interval>& part) {
    return part ? "inside from t = " + text(part->min) + " to " + text(part->max) : "never inside";
}

Verdict told(const Ray& ray, const BoundingBox& box, Interval interval,
             const std::optional<Interval>& expected) {
    const auto got = overlap(ray, box, interval);
    const bool same =
        expected ? got && close(got->min, expected->min, 0) && close(got->max, expected->max, 0)
                 : !got;
    const std::string question = code(ray) + ", " + code(box);
    const std::string paste =
        expected ? "inside(" + question + ", " + code(*expected) : "outside(" + question;
    const bool whole = interval.min == 0 && interval.max == infinity;
    return verdict(same, "overlap(" + code(ray) + ",\n        " + code(box) + ",\n        " +
                             code(interval) + ")\n  got:      " + got_text(got) +
                             "\n  expected: " + got_text(expected) + "\n  paste:    CHECK(" +
                             paste + (whole ? "" : ", " + code(interval)) + "));");
}

/// The ray is in the box for just this part of the interval.
Verdict inside(const Ray& ray, const BoundingBox& box, Interval expected, Interval interval = {}) {
    return told(ray, box, interval, expected);
}

/// The ray is nowhere in the box inside the interval.
Verdict outside(const Ray& ray, const BoundingBox& box, Interval interval = {}) {
    return told(ray, box, interval, std::nullopt);
}

/// A point of a box's face, a tenth of the box away from the others. The faces are 0 to 5.
Vec3 draw_on_face(Random& random, const BoundingBox& box, int face) {
    const glm::length_t axis = face / 2;
    Vec3 share;
    for (glm::length_t i = 0; i < 3; ++i) share[i] = random.between(Real(0.1), Real(0.9));
    share[axis] = Real(face % 2);
    return box.min + share * (box.max - box.min);
}

/// A line that enters the box at t = 0 and leaves it at t = 1: from one face to another.
struct Chord {
    BoundingBox box;
    Ray line;
};

Chord draw_chord(Random& random) {
    const Vec3 corner = random.point(3);
    const Vec3 size = Vec3(1) + abs(random.point(1));
    const BoundingBox box{.min = corner, .max = corner + size};
    const int face = random.below(6);
    const Vec3 enters = draw_on_face(random, box, face);
    const Vec3 leaves = draw_on_face(random, box, (face + 1 + random.below(5)) % 6);
    return {.box = box, .line = {.origin = enters, .direction = leaves - enters}};
}

// Oriented boxes.

/// Around (0, 0, -5), half as wide, high and deep as 2, 4, 6; along the axes.
const OrientedBox upright{.center = {0, 0, -5}, .half_size = {1, 2, 3}};

/// At most 0.9 of the way to an edge.
Sample<OrientedBox> draw_box(Random& random) {
    const Basis basis = random.basis();
    const Vec3 half_size = Vec3(Real(0.5)) + abs(random.point(1));
    const std::array<Vec3, 3> axes = {basis.x, basis.y, basis.z};
    const auto face = glm::length_t(random.below(3));
    const Real sign = random.coin() ? 1 : -1;
    Vec3 share = random.point(Real(0.9));
    share[face] = sign;
    const OrientedBox box{.center = random.point(3), .basis = basis, .half_size = half_size};
    const Vec3 p = share * half_size;
    return {.shape = box,
            .point = box.center + p.x * basis.x + p.y * basis.y + p.z * basis.z,
            .normal = sign * axes[std::size_t(face)]};
}

/// In eighths, along the axes, half sizes powers of two from 1: with rays along or across them
/// nothing is rounded.
OrientedBox draw_box_in_eighths(Random& random) {
    return {.center = random.point_in_eighths(3),
            .basis = random.axes(),
            .half_size = Vec3(1 << random.below(3), 1 << random.below(3), 1 << random.below(3))};
}

}  // namespace

TEST_CASE("a ray is in the box from the last t_min to the first t_max (M1)",
          "[part boxes (overlap)][3 points]") {
    CHECK(inside(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, block, {2, 8}));
    // Through x in 4 to 6, y in 3 to 7, z in 2 to 8.
    CHECK(inside(Ray{.origin = {5, 5, 5}, .direction = {-1, -1, -1}}, block, {4, 6}));
    CHECK(inside(Ray{.origin = {-5, -5, -5}, .direction = {1, 1, 1}}, block, {4, 6}));
    CHECK(inside(Ray{.origin = {5, -5, 5}, .direction = {-1, 1, -1}}, block, {4, 6}));
    // In by one face, out by another: x in 1 to 3, y in 0 to 4, z always.
    CHECK(inside(Ray{.origin = {2, -2, 0}, .direction = {-1, 1, 0}}, block, {1, 3}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real before = random.between(Real(0.1), 2);
        return inside({.origin = at(line, -before), .direction = line.direction}, box,
                      {before, before + 1});
    }));
}

TEST_CASE("a ray that leaves one slab before it enters another misses (M1)") {
    // x in 1 to 3, y in 4 to 8.
    CHECK(outside(Ray{.origin = {2, -6, 0}, .direction = {-1, 1, 0}}, block));
    CHECK(outside(Ray{.origin = {2, 0, 5}, .direction = {0, 0, -1}}, block));
    CHECK(outside(Ray{.origin = {0, -3, 5}, .direction = {0, 0, -1}}, block));
    CHECK(for_all([](Random& random) {
        // Through a point beside a face, and further away from it on one side and on the other.
        const auto [box, line] = draw_chord(random);
        const int face = random.below(6);
        const glm::length_t axis = face / 2;
        Vec3 point = draw_on_face(random, box, face);
        point[axis] += (face % 2 == 0 ? -1 : 1) * random.between(Real(0.1), 1);
        Vec3 direction = random.direction();
        direction[axis] = 0;
        if (direction == Vec3(0)) direction[(axis + 1) % 3] = 1;
        return outside({.origin = point - Real(4) * direction, .direction = direction}, box);
    }));
}

TEST_CASE("t counts in the length of the direction, however short or long it is (PHY, any v)") {
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real length = std::ldexp(Real(1), random.below(81) - 40);
        return inside({.origin = at(line, -1), .direction = length * line.direction}, box,
                      {1 / length, 2 / length});
    }));
}

TEST_CASE("a box behind the eye is missed (erratum 8, M1)") {
    const BoundingBox behind{.min = {-1, -1, 4}, .max = {1, 1, 6}};
    CHECK(outside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, behind));
    CHECK(inside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}}, behind, {4, 6}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real before = random.between(Real(0.1), 2);
        return outside({.origin = at(line, -before), .direction = -line.direction}, box);
    }));
}

TEST_CASE("from inside, a ray is in the box from its start to the first t_max (M1)") {
    CHECK(inside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, block, {0, 3}));
    CHECK(inside(Ray{.origin = {0, 1, 2}, .direction = {0, 1, 0}}, block, {0, 1}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real share = random.between(Real(0.1), Real(0.9));
        return inside({.origin = at(line, share), .direction = line.direction}, box,
                      {0, 1 - share});
    }));
}

namespace {

/// A ray along a face of a box around 0, or along an edge, where it is on a third plane as well.
Verdict inside_along(const BoundingBox& box, glm::length_t face, Vec3 corner, glm::length_t along,
                     int sign, bool edge) {
    Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, 0}};
    ray.direction[along] = Real(sign);
    ray.origin[along] = Real(-16 * sign);
    ray.origin[face] = corner[face];
    const glm::length_t third = 3 - face - along;
    if (edge) ray.origin[third] = corner[third];
    const Real half = box.max[along];
    return inside(ray, box, {16 - half, 16 + half});
}

/// Rays along the axes, whose two other coordinates are such a zero.
Verdict zeros_are_zero(Real zero) {
    const std::array cases = {
        inside(Ray{.origin = {0, 0, 5}, .direction = {zero, zero, -1}}, block, {2, 8}),
        inside(Ray{.origin = {-5, 1, 2}, .direction = {1, zero, zero}}, block, {4, 6}),
        inside(Ray{.origin = {1, -5, -3}, .direction = {zero, 1, zero}}, block, {3, 7}),
        inside(Ray{.origin = {-1, -5, 3}, .direction = {zero, 1, zero}}, block, {3, 7}),
        outside(Ray{.origin = {2, 0, 5}, .direction = {zero, zero, -1}}, block),
        outside(Ray{.origin = {-2, 0, 5}, .direction = {zero, zero, -1}}, block)};
    const auto wrong = std::ranges::find(cases, false, &Verdict::holds);
    return wrong == cases.end() ? Verdict{} : *wrong;
}

}  // namespace

TEST_CASE("a ray along a face or an edge is in the box, though 0 times infinity is NaN (M1)") {
    CHECK(for_all([](Random& random) {
        // Sizes in eighths, which need no rounding.
        const int width = 1 + random.below(64);
        const int height = 1 + random.below(64);
        const Vec3 half = Vec3(width, height, 1 + random.below(64)) / Real(8);
        const BoundingBox box{.min = -half, .max = half};
        const glm::length_t face = random.below(3);
        const glm::length_t along = (face + 1 + random.below(2)) % 3;
        const int sign = random.coin() ? 1 : -1;
        const Vec3 corner = random.coin() ? box.min : box.max;
        return inside_along(box, face, corner, along, sign, random.coin());
    }));
}

TEST_CASE("a coordinate of the direction may be 0, and -0 is 0 (M1, Williams et al.)", "[exact]") {
    CHECK(zeros_are_zero(Real(0)));
    CHECK(zeros_are_zero(-Real(0)));
    CHECK(for_all([](Random& random) {
        // Along an axis, in eighths: nothing is rounded.
        const Vec3 corner = random.point_in_eighths(3);
        const Vec3 size(random.eighths(1, 4), random.eighths(1, 4), random.eighths(1, 4));
        const Real zero = random.coin() ? Real(0) : -Real(0);
        const glm::length_t along = random.below(3);
        const Real t = random.eighths(1, 32);
        Ray ray{.origin = corner + Real(0.5) * size, .direction = Vec3(zero)};
        ray.origin[along] = corner[along] - t;
        ray.direction[along] = 1;
        return inside(ray, {.min = corner, .max = corner + size}, {t, t + size[along]});
    }));
}

TEST_CASE("a flat box is hit: max t_min = min t_max is no miss (M1)", "[exact]") {
    const BoundingBox sheet{.min = {-1, -2, 3}, .max = {1, 2, 3}};
    CHECK(inside(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, sheet, {2, 2}));
    CHECK(inside(Ray{.origin = {3, 0, 0}, .direction = {-1, 0, 1}}, sheet, {3, 3}));
    CHECK(outside(Ray{.origin = {3, 3, 0}, .direction = {-1, 0, 1}}, sheet));
    CHECK(for_all([](Random& random) {
        auto [box, line] = draw_chord(random);
        const glm::length_t axis = random.below(3);
        const Vec3 point = draw_on_face(random, box, int(2 * axis));
        box.max[axis] = box.min[axis];
        Vec3 direction = random.direction();
        if (std::abs(direction[axis]) < Real(0.2)) direction[axis] = 1;
        return inside({.origin = point - Real(3) * direction, .direction = direction}, box, {3, 3});
    }));
}

TEST_CASE("only the part of the ray in the interval counts (contract)") {
    const Ray ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    CHECK(inside(ray, block, {3, 7}, Interval{.min = 3, .max = 7}));
    CHECK(inside(ray, block, {2, 4}, Interval{.min = 1, .max = 4}));
    CHECK(inside(ray, block, {4, 8}, Interval{.min = 4, .max = 9}));
    CHECK(outside(ray, block, Interval{.min = 0, .max = 1}));
    CHECK(outside(ray, block, Interval{.min = 9, .max = infinity}));
}

TEST_CASE("with a coordinate that is not a number, a ray is in no box (contract)") {
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        Ray ray{.origin = at(line, -1), .direction = line.direction};
        Vec3& part = random.coin() ? ray.origin : ray.direction;
        part[random.below(3)] = std::numeric_limits<Real>::quiet_NaN();
        return outside(ray, box);
    }));
}

TEST_CASE("a ray meets the near face of an oriented box, half a size from its center (M1)",
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

TEST_CASE("rays aimed at a point of an oriented box meet it there (M1)") {
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

TEST_CASE("from inside, an oriented box is met where the ray leaves it (M1)") {
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

TEST_CASE("a ray along a face, into an edge or past an edge that it touches meets the box (M1)",
          "[exact]") {
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

TEST_CASE("an oriented box is met however near it is (erratum 31, contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {0, 0, near - 2}, .direction = {0, 0, -1}}, upright, near));
    CHECK(hits(Ray{.origin = {0, 0, 1}, .direction = {0, 0, -3 / near}}, upright, near));
    CHECK(for_all([near](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 met = box.center + random.eighths(-1, 1) * x + box.half_size.z * z;
        const Real t = random.eighths(1, 32);
        return hits({.origin = met + t * z, .direction = -t / near * z}, box, near);
    }));
}

TEST_CASE("a ray that leaves a face does not meet it at once (PHY, t > 0)", "[exact]") {
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

TEST_CASE("only faces strictly inside the interval are met (contract)", "[exact]") {
    const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(hits(ray, upright, 8, Interval{.min = 3, .max = infinity}));
    CHECK(misses(ray, upright, Interval{.min = 3, .max = 7}));
    CHECK(misses(ray, upright, Interval{.min = 0, .max = 2}));
    CHECK(interval_is_kept(draw_box));
}

TEST_CASE("the normal is that of the face, not of the largest coordinate (M1)") {
    CHECK(normal_is(upright, {1, Real(1.5), -5}, {1, 0, 0}));
    CHECK(normal_is(upright, {-1, Real(1.5), Real(-7.5)}, {-1, 0, 0}));
    CHECK(normal_is(upright, {Real(0.5), 2, Real(-7.5)}, {0, 1, 0}));
    CHECK(normal_is(upright, {Real(0.5), -2, -5}, {0, -1, 0}));
    CHECK(normal_is(upright, {0, 0, -8}, {0, 0, -1}));
    CHECK(normals_point_outward(draw_box));
}

TEST_CASE("a box is the same box after everything has moved, turned and grown (HAI)") {
    CHECK(motion_changes_nothing(draw_box));
}

TEST_CASE("with a coordinate that is not a number, a ray misses an oriented box (contract)") {
    CHECK(nan_misses(draw_box));
}
