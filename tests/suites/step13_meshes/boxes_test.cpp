// Boxes along the axes, against M1.
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/shape_checks.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

/// From (-1, -2, -3) to (1, 2, 3).
const BoundingBox block{.min = {-1, -2, -3}, .max = {1, 2, 3}};

std::string got_text(const std::optional<Interval>& part) {
    return part ? "inside from t = " + text(part->min) + " to " + text(part->max) : "never inside";
}

Verdict overlap_is(const Ray& ray, const BoundingBox& box, Interval interval,
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
    return overlap_is(ray, box, interval, expected);
}

/// The ray is nowhere in the box inside the interval.
Verdict outside(const Ray& ray, const BoundingBox& box, Interval interval = {}) {
    return overlap_is(ray, box, interval, std::nullopt);
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

TEST_CASE("a ray almost parallel to a slab crosses it (contract)") {
    const Real far = std::ldexp(Real(1), 20);
    CHECK(inside(Ray{.origin = {-far, Real(-2.5), 0}, .direction = {1, 1 / far, 0}}, block,
                 {far - 1, far + 1}));
    CHECK(outside(Ray{.origin = {-far, Real(-3.5), 0}, .direction = {1, 1 / far, 0}}, block));
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

TEST_CASE("a ray along a face or an edge is in the box (M1)") {
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

TEST_CASE("rays through a box without thickness hit it (M1)", "[exact]") {
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
    // By a hair past an edge, and by a hair inside of it:
    // x in 2 to 4, y in 4 to 6, but for a hair.
    const BoundingBox unit_box{.min = {-1, -1, -1}, .max = {1, 1, 1}};
    const Real gap = 4 * hair;
    CHECK(outside(Ray{.origin = {3, -5 - gap, 0}, .direction = {-1, 1, 0}}, unit_box));
    CHECK(inside(Ray{.origin = {3, -5 + gap, 0}, .direction = {-1, 1, 0}}, unit_box, {4 - gap, 4}));
    CHECK(outside(Ray{.origin = {-1 - hair, 0, 5}, .direction = {0, 0, -1}}, unit_box));
    CHECK(inside(Ray{.origin = {-1 + hair, 0, 5}, .direction = {0, 0, -1}}, unit_box, {4, 6}));
}

TEST_CASE("only the part of the ray in the interval counts (contract)") {
    const Ray ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    CHECK(inside(ray, block, {3, 7}, Interval{.min = 3, .max = 7}));
    CHECK(inside(ray, block, {2, 4}, Interval{.min = 1, .max = 4}));
    CHECK(inside(ray, block, {4, 8}, Interval{.min = 4, .max = 9}));
    CHECK(outside(ray, block, Interval{.min = 0, .max = 1}));
    CHECK(outside(ray, block, Interval{.min = 9, .max = infinity}));
    const Ray from_within{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(inside(from_within, block, {-3, 3}, Interval{.min = -9, .max = infinity}));
    CHECK(inside(from_within, block, {-1, 3}, Interval{.min = -1, .max = infinity}));
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
