// Ties: whole coordinates, for which a ray often touches, runs along a surface, or hits an edge.
// And the numbers that decide them, against the oracle's.
#include "tests/oracle/inputs.hpp"
#include "tests/stability/sweeps.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "common/exact/dyadic.hpp"

#include "tests/kit/for_all.hpp"

using namespace rt;

namespace {

Vec3 whole(Random& random, int reach) {
    const auto number = [&] { return Real(random.below(2 * reach + 1) - reach); };
    const Real x = number();
    const Real y = number();
    return {x, y, number()};
}

Vec3 whole_direction(Random& random, int reach) {
    const Vec3 v = whole(random, reach);
    return v == Vec3(0) ? Vec3(0, 0, -1) : v;
}

Vec3 axis(Random& random) {
    Vec3 v(0);
    v[random.below(3)] = random.coin() ? 1 : -1;
    return v;
}

Real length(Random& random) {
    return Real(1 + random.below(3));
}

void tied(Random& random, Sphere& sphere) {
    sphere = {.center = whole(random, 2), .radius = length(random)};
}

void tied(Random& random, Plane& plane) {
    plane = {.point = whole(random, 2), .normal = whole_direction(random, 2)};
}

void tied(Random& random, Triangle& triangle) {
    const Vec3 a = whole(random, 3);
    const Vec3 b = whole(random, 3);
    triangle = {.a = a, .b = b, .c = whole(random, 3)};
}

void tied(Random& random, Square& square) {
    const Vec3 z = axis(random);
    const Vec3 x(z.y, z.z, z.x);
    square = {.center = whole(random, 2),
              .basis = {.x = x, .y = cross(z, x), .z = z},
              .side = 2 * length(random),
              .one_sided = random.coin()};
}

void tied(Random& random, Cylinder& cylinder) {
    cylinder = {.center = whole(random, 2),
                .axis = axis(random),
                .radius = length(random),
                .height = 2 * length(random)};
}

void tied(Random& random, Cone& cone) {
    cone = {.apex = whole(random, 2),
            .axis = axis(random),
            .radius = length(random),
            .height = length(random)};
}

/// Equality, as far as a double can represent it.
Verdict is_exact(const oracle::Exact& exact, const DoubleDouble& rounded) {
    const oracle::Number off =
        abs(exact.number() - oracle::Number(rounded.high) - oracle::Number(rounded.low));
    return verdict(off <= oracle::Number(Real(1.01) * rounded.error),
                   "is off by " + off.str(5) + ", and says " + std::to_string(rounded.error));
}

}  // namespace

TEMPLATE_TEST_CASE("ties are decided as exact arithmetic does", "", Sphere, Plane, Triangle, Square,
                   Cylinder, Cone) {
    CHECK(for_all(
        [](Random& random) {
            Case<TestType> asked;
            tied(random, asked.shape);
            asked.ray = {.origin = whole(random, 5), .direction = whole_direction(random, 3)};
            const Interval interval{.min = Real(random.below(3)), .max = infinity};
            const auto got = intersect(asked.ray, asked.shape, interval);
            const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(interval));
            std::optional<Real> expected;
            if (root) expected = root->value().template convert_to<Real>();
            return verdict(got.has_value() == expected.has_value() &&
                               (!got || std::abs(*got - *expected) <= 8 * epsilon * *got),
                           intersection_report(asked.ray, asked.shape, interval, got, expected));
        },
        20'000));
}

TEST_CASE("sums and products of dyadic numbers are exact, those of two words within their bounds") {
    CHECK(for_all(
        [](Random& random) {
            // Numbers of very different sizes, and their opposites, so that most of it cancels.
            oracle::Exact exact = 1;
            Dyadic dyadic = Real(1);
            DoubleDouble words = Real(1);
            Real last = 1;
            for (int i = 0; i < 12; ++i) {
                const Real drawn = random.between(-1, 1) * std::ldexp(Real(1), random.below(60));
                const Real number = random.coin() ? drawn : -last;
                last = number;
                if (random.coin() || number == 0) {
                    exact = exact + oracle::Exact(number);
                    dyadic = dyadic + Dyadic(number);
                    words = words + DoubleDouble(number);
                } else {
                    exact = exact * oracle::Exact(number) - oracle::Exact(number);
                    dyadic = dyadic * Dyadic(number) - Dyadic(number);
                    words = words * DoubleDouble(number) - DoubleDouble(number);
                }
            }
            const auto sign = words.sign();
            Verdict held = verdict(dyadic.sign() == exact.sign(), "the dyadic number's sign");
            if (held) held = verdict(!sign || sign == exact.sign(), "the sign of two words");
            if (held) held = is_exact(exact, dyadic.rounded());
            return held ? is_exact(exact, words) : held;
        },
        20'000));
}
