// vector.hpp and compensated.hpp against whole numbers, with which every sum here is exact.

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "tests/kit/for_all.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace rt;

namespace {

using Whole = std::int64_t;

constexpr int digits = std::numeric_limits<Real>::digits;
constexpr Real u = unit_roundoff;

/// −2^bits to 2^bits.
Whole whole(Random& random, int bits) {
    return static_cast<Whole>(std::round((random.choice() * 2 - 1) * std::ldexp(1.0, bits)));
}

/// A whole number that a Real represents exactly.
Real real(Whole value) {
    REQUIRE(static_cast<Whole>(static_cast<Real>(value)) == value);
    return static_cast<Real>(value);
}

Verdict exact(Rounded got, Real plain, Whole expected) {
    const Whole sum = static_cast<Whole>(got.value) + static_cast<Whole>(got.dropped);
    return verdict(
        got.value == plain && sum == expected,
        text(got.value) + " and " + text(got.dropped) + " are not " + std::to_string(expected));
}

Verdict within(Real got, Whole expected, Real error) {
    // |expected| may have more bits than a Real: the difference is computed in whole numbers.
    const Real off = std::abs(static_cast<Real>(static_cast<Whole>(got) - expected));
    const bool is_whole = got == std::trunc(got);
    return verdict(is_whole && off <= error, text(got) + " is not " + std::to_string(expected));
}

}  // namespace

TEST_CASE("unit() has length 1 and the same direction, at every length (common/math/vector.hpp)") {
    // Whole vectors of a whole length: (m²+n²−p²−q², 2(mq+np), 2(nq−mp)) of length m²+n²+p²+q².
    CHECK(for_all(
        [](Random& random) {
            const int m = random.below(9) + 1;
            const int n = random.below(10);
            const int p = random.below(10);
            const int q = random.below(10);
            const int size = m * m + n * n + p * p + q * q;
            const Vec3 v(m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p));
            constexpr int least = std::numeric_limits<Real>::min_exponent - digits;
            constexpr int most = std::numeric_limits<Real>::max_exponent - 10;
            const int exponent = least + random.below(most - least + 1);
            const auto scaled = [exponent](Real x) { return std::ldexp(x, exponent); };
            const Vec3 got = unit({scaled(v.x), scaled(v.y), scaled(v.z)});
            const Vec3 off = abs(got - v / Real(size));
            return verdict(std::max({off.x, off.y, off.z}) <= 4 * u,
                           "unit() of 2^" + std::to_string(exponent) + " " + text(v) + " came as " +
                               text(got));
        },
        20000));
}

TEST_CASE("unit() at the ends of the numbers, and of nothing") {
    constexpr Real most = std::numeric_limits<Real>::max();
    constexpr Real least = std::numeric_limits<Real>::denorm_min();
    const Real third = 1 / std::sqrt(Real(3));
    CHECK(unit({0, -most, 0}) == Vec3(0, -1, 0));
    CHECK(unit({least, 0, 0}) == Vec3(1, 0, 0));
    CHECK(unit({most, least, 0}) == Vec3(1, 0, 0));
    CHECK(length(unit({most, -most, most}) - Vec3(third, -third, third)) <= 4 * u);
    CHECK(length(unit({least, least, -least}) - Vec3(third, third, -third)) <= 4 * u);
    const Vec3 none = unit({0, 0, 0});
    CHECK((std::isnan(none.x) && std::isnan(none.y) && std::isnan(none.z)));
}

TEST_CASE("facing() turns a normal against the ray, and keeps one at right angles") {
    const Vec3 n(0, 0, 1);
    CHECK(face_forward(n, {0, 0, -1}) == n);
    CHECK(face_forward(n, {0, 0, 1}) == -n);
    CHECK(face_forward(n, {1, 0, 0}) == n);
}

TEST_CASE("exact_sum() loses nothing, in either order") {
    CHECK(for_all(
        [](Random& random) {
            // Magnitudes so different that the sum has more digits than a Real.
            const Real a = std::ldexp(real(whole(random, digits - 2)), 8);
            const Real b = real(whole(random, digits));
            const Whole sum = static_cast<Whole>(a) + static_cast<Whole>(b);
            if (const Verdict first = exact(exact_sum(a, b), a + b, sum); !first) return first;
            return exact(exact_sum(b, a), a + b, sum);
        },
        5000));
}

TEST_CASE("exact_product() loses nothing") {
    CHECK(for_all(
        [](Random& random) {
            const int bits = std::min(digits, 31);
            const Whole a = whole(random, bits);
            const Whole b = whole(random, bits);
            return exact(exact_product(real(a), real(b)), real(a) * real(b), a * b);
        },
        5000));
}

TEST_CASE("difference_of_products() keeps the digits where two large products nearly cancel") {
    // (2^(p−1) + 1)², minus the product of its neighbors: 1, where plain arithmetic gives 0 or
    // worse.
    const Real n = std::ldexp(Real(1), digits - 1) + 1;
    CHECK(difference_of_products(n, n, n - 1, n + 1) == 1);
    CHECK(difference_of_products(n - 1, n + 1, n, n) == -1);
    CHECK(for_all(
        [](Random& random) {
            const Whole a = whole(random, digits - 1);
            const Whole b = whole(random, digits - 1);
            const Whole i = whole(random, 7);
            const Whole j = whole(random, 7);
            const Real ab_cd = difference_of_products(real(a), real(b), real(a + i), real(b + j));
            const Real cd_ab = difference_of_products(real(a + i), real(b + j), real(a), real(b));
            const Whole expected = -(a * j + b * i + i * j);
            const Real ulps = 3 * u * std::abs(static_cast<Real>(expected));  // 1.5 ulp at most
            if (const Verdict good = within(ab_cd, expected, ulps); !good) return good;
            const bool opposite = expected == 0 ? cd_ab == 0 : (cd_ab > 0) == (expected < 0);
            return verdict(opposite, "exchanged: " + text(cd_ab) + ", " + text(ab_cd));
        },
        5000));
}

TEST_CASE("compensated_sum() is accurate however many digits cancel") {
    const Real s = u * u;
    const Real least = s * s * s;
    using Terms = std::array<Real, 7>;
    CHECK(compensated_sum(Terms{1, s, s * s, least, -1, -s, -s * s}) == least);
    CHECK(compensated_sum(Terms{least, s * s, s, 1, -s, -1, -s * s}) == least);
    CHECK(compensated_sum(Terms{least, -1, s * s, -s, s, 1, -s * s}) == least);
    CHECK(compensated_sum(Terms{1, -1, s, -s, 0, 0, 0}) == 0);
}

TEST_CASE("compensated_dot() is as good as with twice the digits") {
    const Real big = std::ldexp(Real(1), digits);
    CHECK(compensated_dot({big, 1, -big}, {1, 1, 1}) == 1);
    CHECK(compensated_dot({big, 1, big}, {big, 1, -big}) == 1);
    CHECK(for_all(
        [](Random& random) {
            const int bits = std::min(digits, 29);
            const Whole x = whole(random, bits);
            const Whole y = whole(random, bits);
            const Whole z = whole(random, bits);
            const Whole k = whole(random, 3);
            // ⟨(x, y, z), (y + k, −x, 1)⟩ = k x + z: far less than x y.
            const Vec3 a(real(x), real(y), real(z));
            const Vec3 b(real(y + (y > 0 ? -k * k : k * k)), real(-x), 1);
            const Whole expected = x * (y > 0 ? -k * k : k * k) + z;
            const Real products = 2 * std::abs(real(x)) * std::abs(real(y));
            return within(compensated_dot(a, b), expected,
                          2 * u * std::abs(static_cast<Real>(expected)) + 64 * u * u * products);
        },
        5000));
}

TEST_CASE("compensated_dot() of a difference takes the difference exactly") {
    const Real big = std::ldexp(Real(1), digits + 1);
    // big − 1 has one digit too many; the products along x and y cancel up to the 1.
    CHECK(compensated_dot({1, 1, 0}, {big, -big, 0}, {1, 0, 0}) == -1);
    CHECK(compensated_dot({1, -1, 3}, {big, big, 0}, {1, 2, -1}) == 4);
    CHECK(compensated_dot({0, 0, 1}, {big, big, 7}, {-big, big, 5}) == 2);
}
