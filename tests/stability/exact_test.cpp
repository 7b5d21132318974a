// The certified kernels of `--precision exact`, which are linked to the sweeps and climbs of the
// stability suite, too. Here are ties: whole coordinates, for which a ray often touches, runs along
// a surface, or hits an edge; the numbers that decide them, against the oracle's; and the largest
// known errors.
#include "tests/oracle/inputs.hpp"
#include "tests/stability/judge.hpp"
#include "tests/stability/promises.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include "common/exact/dyadic.hpp"

#include "tests/kit/for_all.hpp"

using namespace rt;

bool rt::are_certified() {
    return true;
}

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

TEST_CASE("the largest known errors of certified t, and cases with underflowing products") {
    const auto check = [](const auto& asked, double bound) {
        const auto got = intersect(asked.ray, asked.shape, {});
        INFO(intersection_report(asked.ray, asked.shape, {}, got, std::nullopt));
        CHECK(judged(asked, got).ulps.value_or(unbounded) <= bound);
    };
    check(
        Case<Triangle>{
            .ray = {{-0x1.01b98db21589p-357, -0x1.783616e0e613bp-358, -0x1.6816765d5121ep-356},
                    {0x1.bf1c59322491bp-2, 0x1.3852ee8a38e67p-1, 0x1.195c0bea21e14p+0}},
            .shape = {{-0x1.50eed9eedc3a4p-360, 0x1.c0566a6ec7352p-359, -0x1.5dae57bef7523p-359},
                      {-0x1.0d52290e6b118p-358, 0x1.083ff73198901p-358, -0x1.03717969e72acp-357},
                      {-0x1.0a033cdf5ab27p-366, 0x1.114d339923b31p-358, -0x1.200a87fee4b6dp-357}}},
        1);
    check(
        Case<Plane>{
            .ray = {{0x1.017260cbed26dp+3, 0x1.1f914d2adfcb4p+1, -0x1.69bbcf24bbac7p-1},
                    {-0x1.243cd6eafc6ebp+2, -0x1.a63a0ac1dd444p-2, 0x1.5f766130f1095p-2}},
            .shape = {{-0x1.4eea54da2b55ep-3, -0x1.f2d1e5cb183c6p+0, 0x1.c0081247a7483p-3},
                      {0x1.07cc556c3c5c5p-1, -0x1.9eabab6ad3e38p-1, -0x1.d4b02740df06ap-3}}},
        bars_of<Plane>().ulps);
    check(
        Case<Sphere>{
            .ray = {{-0x1.bfa161a866657p+46, -0x1.278ff715717a7p+48, -0x1.a7a397e6200c3p+48},
                    {-0x1.001442fbef3b3p-5, 0x1.2470a25c70b5fp-1, 0x1.a917c66f676f7p-1}},
            .shape = {{0x1.f81f288684e6p+44, -0x1.25dcece53ff6cp+43, -0x1.57ea7dc217eb1p+44},
                      0x1.3e9eb7cbc8ed6p+47}},
        bars_of<Sphere>().ulps);
    check(
        Case<Cone>{
            .ray = {{-0x1.2ef0ec51990d9p+19, -0x1.2b810f487a29ep+23, -0x1.1ec60777bf855p+20},
                    {-0x1.96dffdd592c86p+37, -0x1.7e01abc57b226p+38, 0x1.d399d04b11083p+33}},
            .shape = {{-0x1.7c46c54afff45p+20, -0x1.b3193a8e864c4p+24, -0x1.5f40bd1ee5bd6p+19},
                      {0x1.ee6e8e4e92138p-1, 0x1.4f1187eaa769ap-3, 0x1.9d12117e09b7bp-3},
                      0x1.dfa38d211bbf1p+23,
                      0x1.454f7fe736cbap+0}},
        bars_of<Cone>().ulps);
}
