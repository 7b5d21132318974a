// The points that soft shadows are sampled with: common/render/sampling.hpp.
#include "common/render/sampling.hpp"

#include "common/system/hash.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/for_all.hpp"
#include "tests/suites/step11_soft_shadows/share_of_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>
#include <vector>

using namespace rt;

namespace {

std::string call(std::uint32_t index, std::uint32_t seed) {
    return "spread_sample(" + std::to_string(index) + ", " + std::to_string(seed) + ")";
}

/// 2^k points from `first` on are stratified: one lies in each of 2^k boxes, 2^across columns of
/// 2^(k − across).
Verdict stratified(std::uint32_t first, unsigned k, unsigned across, std::uint32_t seed) {
    std::vector<int> counts(std::size_t(1) << k);
    for (std::uint32_t i = 0; i < 1U << k; ++i) {
        const Vec2 point = spread_sample(first + i, seed);
        const auto column = std::size_t(std::ldexp(point.x, int(across)));
        const auto row = std::size_t(std::ldexp(point.y, int(k - across)));
        ++counts.at((column << (k - across)) + row);
    }
    const auto most = *std::max_element(counts.begin(), counts.end());
    return verdict(most == 1, std::to_string(1U << k) + " points from " + call(first, seed) +
                                  " on, in " + std::to_string(1U << across) + " x " +
                                  std::to_string(1U << (k - across)) + " boxes\n  got:      " +
                                  std::to_string(most) + " in one box\n  expected: one in each");
}

/// χ² of counts that should all be equal.
double chi_squared(const std::vector<int>& counts) {
    double all = 0;
    for (const int count : counts) all += count;
    const double expected = all / double(counts.size());
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

/// In 256 boxes, χ² has mean 255 and standard deviation √(2 · 255) = 22.6: six of them above.
constexpr double chi_squared_bound = 255 + 6 * 22.6;

std::size_t box_of(Vec2 point) {
    return std::size_t(point.x * 16) * 16 + std::size_t(point.y * 16);
}

/// In units of 2^-24.
std::array<std::uint32_t, 2> whole(Vec2 point) {
    return {std::uint32_t(point.x * 16777216), std::uint32_t(point.y * 16777216)};
}

}  // namespace

TEST_CASE("samples: the first 2^k lie one in each of 2^k boxes, however the square is halved") {
    CHECK(for_all([](Random& random) {
        const auto k = unsigned(random.below(13));
        return stratified(0, k, unsigned(random.below(int(k) + 1)), draw_seed(random));
    }));
    for (unsigned across = 0; across <= 10; ++across) CHECK(stratified(0, 10, across, 7));
}

TEST_CASE("samples: so do the next 2^k, so that more rays fill the gaps of the first") {
    CHECK(for_all([](Random& random) {
        const auto k = unsigned(random.below(9));
        const auto first = std::uint32_t(random.below(16)) << k;
        return stratified(first, k, unsigned(random.below(int(k) + 1)), draw_seed(random));
    }));
}

TEST_CASE("samples: both numbers are from 0 to 1 without 1, and multiples of 2^-24") {
    CHECK(for_all([](Random& random) {
        const auto index = std::uint32_t(random.below(1 << 20));
        const std::uint32_t seed = draw_seed(random);
        const Vec2 point = spread_sample(index, seed);
        const Vec2 steps = point * Real(16777216);
        const bool fits = point.x >= 0 && point.x < 1 && point.y >= 0 && point.y < 1;
        return verdict(fits && steps == floor(steps),
                       call(index, seed) + "\n  got:      " + text(point) +
                           "\n  expected: multiples of 2^-24 below 1");
    }));
}

TEST_CASE("samples: each point alone is uniform over the seeds of a picture's pixels") {
    for (const std::uint32_t index : {0U, 1U, 2U, 3U, 7U, 64U, 1000U}) {
        std::vector<int> counts(256);
        for (int row = 0; row < 240; ++row)
            for (int column = 0; column < 320; ++column)
                ++counts[box_of(spread_sample(index, sample_seed({row, column}, 1, 0)))];
        CHECK(chi_squared(counts) < chi_squared_bound);
    }
}

TEST_CASE("samples: neighbors, lights and bounces have points of their own") {
    // The quarters of each of two points: 16 times 16 boxes, as uniform as if independent.
    const auto quarter = [](Vec2 point) {
        return std::size_t(point.x * 4) * 4 + std::size_t(point.y * 4);
    };
    std::vector<int> beside(256);
    std::vector<int> below(256);
    std::vector<int> other_light(256);
    std::vector<int> other_bounce(256);
    for (int row = 0; row < 240; ++row)
        for (int column = 0; column < 320; ++column) {
            const auto of = [&](Pixel pixel, std::uint32_t light, std::uint32_t bounce) {
                return quarter(spread_sample(0, sample_seed(pixel, light, bounce)));
            };
            const std::size_t here = 16 * of({row, column}, 1, 0);
            ++beside[here + of({row, column + 1}, 1, 0)];
            ++below[here + of({row + 1, column}, 1, 0)];
            ++other_light[here + of({row, column}, 2, 0)];
            ++other_bounce[here + of({row, column}, 1, 1)];
        }
    CHECK(chi_squared(beside) < chi_squared_bound);
    CHECK(chi_squared(below) < chi_squared_bound);
    CHECK(chi_squared(other_light) < chi_squared_bound);
    CHECK(chi_squared(other_bounce) < chi_squared_bound);
}

TEST_CASE("samples: shuffled, the first 2^k are a whole block of 2^k") {
    CHECK(for_all([](Random& random) {
        const auto k = unsigned(random.below(10));
        const std::uint32_t seed = draw_seed(random);
        std::vector<bool> seen(std::size_t(1) << k);
        const std::uint32_t block = shuffled(0, seed) >> k;
        bool together = true;
        for (std::uint32_t i = 0; i < seen.size(); ++i) {
            const std::uint32_t index = shuffled(i, seed);
            together = together && index >> k == block;
            seen[index % seen.size()] = true;
        }
        const bool all = std::find(seen.begin(), seen.end(), false) == seen.end();
        return verdict(together && all, "2^" + std::to_string(k) + " indices, shuffled with " +
                                            std::to_string(seed) + ", are not a block");
    }));
}

TEST_CASE("samples: shuffled, two sequences are not left and right together") {
    // Points 0 and 2 of a sequence lie on the same side. Of two sequences that are not shuffled,
    // either both points are on the same side, or neither: a pixel's rays on the left would see the
    // left of a light.
    std::vector<int> counts(4);
    for (int row = 0; row < 240; ++row)
        for (int column = 0; column < 320; ++column) {
            const std::uint32_t pixel = sample_seed({row, column}, 0, 0);
            const std::uint32_t light = sample_seed({row, column}, 1, 0);
            const auto agree = [&](std::uint32_t index) {
                const std::uint32_t other = shuffled(index, mixed_bits(light));
                return (spread_sample(index, pixel).x < Real(0.5)) ==
                       (spread_sample(other, light).x < Real(0.5));
            };
            ++counts[2 * std::size_t(agree(0)) + std::size_t(agree(2))];
        }
    // In 4 boxes, χ² has mean 3 and standard deviation √6: six of them above.
    CHECK(chi_squared(counts) < 3 + 6 * 2.45);
}

TEST_CASE("samples: no two pixels of a large picture have the same seed, nearly") {
    std::vector<std::uint32_t> seeds;
    for (int row = 0; row < 480; ++row)
        for (int column = 0; column < 640; ++column)
            seeds.push_back(sample_seed({row, column}, 1, 0));
    std::sort(seeds.begin(), seeds.end());
    const auto same = seeds.end() - std::unique(seeds.begin(), seeds.end());
    // The expected number for independent ones is n² / 2 / 2^32 = 11, with a deviation of 3.3; the
    // bound is six of these.
    CHECK(same < 31);
}

TEST_CASE("samples: any thread, in any order, gets the same points") {
    constexpr std::uint32_t count = 4096;
    std::vector<Vec2> expected;
    for (std::uint32_t i = 0; i < count; ++i) expected.push_back(spread_sample(i, 2021));
    std::array<std::vector<Vec2>, 4> got;
    std::vector<std::thread> threads;
    for (std::vector<Vec2>& points : got)
        threads.emplace_back([&points] {
            points.resize(count);
            for (std::uint32_t i = count; i-- > 0;) points[i] = spread_sample(i, 2021);
        });
    for (std::thread& thread : threads) thread.join();
    for (const std::vector<Vec2>& points : got) CHECK((points == expected));
}

TEST_CASE("samples: both precisions have the same points, those of Burley 2020") {
    // Worked out from the paper, bit by bit, in units of 2^-24 (Python, arbitrary precision).
    struct Known {
        std::uint32_t index;
        std::uint32_t seed;
        std::array<std::uint32_t, 2> point;
    };
    constexpr std::array known = {
        Known{0U, 0U, {0U, 0U}},
        Known{1U, 0U, {10907104U, 10907104U}},
        Known{2U, 0U, {5453552U, 15437411U}},
        Known{5U, 0U, {9154620U, 2726776U}},
        Known{1023U, 0U, {14497964U, 5385237U}},
        Known{123456U, 0U, {186038U, 6300253U}},
        Known{0U, 1U, {10907104U, 13142953U}},
        Known{1U, 1U, {5453552U, 1673402U}},
        Known{2U, 1U, {15437411U, 4949381U}},
        Known{5U, 1U, {7718705U, 16147564U}},
        Known{1023U, 1U, {10651U, 12320557U}},
        Known{123456U, 1U, {10790202U, 9055506U}},
        Known{0U, 2021U, {9216202U, 3992246U}},
        Known{1U, 2021U, {7562970U, 10094530U}},
        Known{2U, 2021U, {12658789U, 13902837U}},
        Known{5U, 2021U, {4456398U, 788830U}},
        Known{1023U, 2021U, {3019978U, 6653144U}},
        Known{123456U, 2021U, {9417556U, 4851711U}},
        Known{0U, 3735928559U, {13976459U, 11608785U}},
        Known{1U, 3735928559U, {876062U, 4299748U}},
        Known{2U, 3735928559U, {11251656U, 4131624U}},
        Known{5U, 3735928559U, {2387790U, 10039557U}},
        Known{1023U, 3735928559U, {6671866U, 16610731U}},
        Known{123456U, 3735928559U, {14056159U, 13343293U}},
    };
    for (const auto& [index, seed, point] : known) {
        INFO(call(index, seed));
        CHECK(whole(spread_sample(index, seed)) == point);
    }
}

// The share of a light beside a plane, with which stage 11's suite computes what it expects.

TEST_CASE("the share of a cone beside a plane is integrated to 1e-6") {
    // The piece of a cap that a great circle cuts off, by Girard's theorem.
    for (const double half_angle : {0.01, 0.5, 1.0, 1.5})
        for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999}) {
            const double offset = part * half_angle;
            const double piece =
                2 * std::acos(std::sin(offset) / std::sin(half_angle)) -
                2 * std::cos(half_angle) * std::acos(std::tan(offset) / std::tan(half_angle));
            const double share = piece / (2 * exact_pi * (1 - std::cos(half_angle)));
            CHECK(std::abs(share_beside_plane(-offset, half_angle) - share) < 1e-6);
            CHECK(std::abs(share_beside_plane(offset, half_angle) - (1 - share)) < 1e-6);
        }
}
