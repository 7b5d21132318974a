// The visible share of a light, and its error, against CR §3.3.
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "tests/kit/light.hpp"
#include "tests/suites/step11_soft_shadows/share_of_light.hpp"

#include "common/render/render_settings.hpp"
#include "common/render/sampling.hpp"

#include <algorithm>
#include <map>
#include <vector>

using namespace rt;

namespace {

Verdict is(const std::string& what, Real got, Real expected, const std::string& paste) {
    return verdict(close(got, expected), what + "\n  got:      " + text(got) +
                                             "\n  expected: " + text(expected) +
                                             "\n  paste:    CHECK(" + paste + ");");
}

std::string code(const ShadowRays& rays) {
    return "ShadowRays{.sent = " + std::to_string(rays.sent) +
           ", .reached = " + std::to_string(rays.reached) + "}";
}

Verdict share_is(const ShadowRays& rays, Real expected) {
    return is("visibility(" + code(rays) + ")", visibility(rays), expected,
              "share_is(" + code(rays) + ", " + rt::code(expected) + ")");
}

/// Points of a disc, well spread, and straight edges: the root mean square of the error of the
/// visible share over its estimate. The points are the suite's own, so that visibility_error alone
/// is tested. They are as well spread for any count as the stage's are for powers of two: the true
/// error is 0.51 to 0.84 times the reference's estimate, for 12 counts of each octave from 8 to
/// 2048.
struct Honesty {
    double squares = 0;
    std::map<int, double> estimates;  ///< by the number of free rays: computed once
};

double unit_interval(std::mt19937_64& engine) {
    return double(engine() >> 11) * 0x1p-53;
}

std::vector<glm::dvec2> well_spread_points(int count, std::mt19937_64& engine) {
    const auto seed = std::uint32_t(engine());
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt((i + unit_interval(engine)) / count);
        const double turn = 2 * exact_pi * double(spread_sample(std::uint32_t(i), seed).x);
        points.push_back(radius * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    return points;
}

/// `edge` is the distance of a shadow's edge from the middle of the light, in a random direction.
void measure(Honesty& honesty, double edge, const std::vector<glm::dvec2>& points,
             std::mt19937_64& engine) {
    const double hidden = (std::acos(edge) - edge * std::sqrt(1 - edge * edge)) / exact_pi;
    const double angle = 2 * exact_pi * unit_interval(engine);
    const glm::dvec2 across(std::cos(angle), std::sin(angle));
    const auto reached = std::ranges::count_if(
        points, [&](const glm::dvec2& point) { return dot(point, across) < edge; });
    const ShadowRays rays{.sent = int(points.size()), .reached = int(reached)};
    const double error = double(rays.reached) / rays.sent - (1 - hidden);
    const auto [entry, is_new] = honesty.estimates.try_emplace(rays.reached);
    if (is_new) entry->second = double(visibility_error(rays));
    honesty.squares += error * error / (entry->second * entry->second);
}

/// Edges with these distances from the middle of the light, whose radius is 1. One seed generates
/// all of them, and the counts, so that no table contains the estimates.
Verdict honest(double from, double to) {
    const auto ask = [from, to](Random& random) {
        std::mt19937_64 engine(draw_seed(random));
        constexpr int edges = 3000;
        constexpr int edges_of_points = 10;  // as points cost more than edges
        for (int octave = 8; octave < 1024; octave *= 2) {
            const int sent = octave + int(engine() % std::uint64_t(octave));
            Honesty honesty;
            for (int i = 0; i < edges; i += edges_of_points) {
                const std::vector<glm::dvec2> points = well_spread_points(sent, engine);
                for (int j = 0; j < edges_of_points; ++j) {
                    const double edge = from + (to - from) * unit_interval(engine);
                    measure(honesty, edge, points, engine);
                }
            }
            const auto ratio = Real(std::sqrt(honesty.squares / edges));
            if (!(ratio <= 1 && ratio >= Real(0.1)))
                return verdict(false, "visibility_error for " + std::to_string(sent) +
                                          " rays, and a shadow with a straight edge somewhere on "
                                          "the light\n  got:      the true error is " +
                                          text(ratio) +
                                          " times the estimate (root mean square of 3000)\n"
                                          "  expected: at most once, at least 0.1 times");
        }
        return Verdict{};
    };
    return for_all(ask, 1);
}

}  // namespace

TEST_CASE("the share is that of the rays that reach the light (CR §3.3)", "[part visibility]") {
    CHECK(share_is({.sent = 4, .reached = 3}, Real(0.75)));
    CHECK(share_is({.sent = 16, .reached = 1}, Real(0.0625)));
    CHECK(share_is({.sent = 16, .reached = 0}, 0));
    CHECK(share_is({.sent = 16, .reached = 16}, 1));
    CHECK(share_is({.sent = 1, .reached = 1}, 1));
    CHECK(share_is({.sent = most_shadow_samples, .reached = most_shadow_samples / 4}, Real(0.25)));
    CHECK(for_all([](Random& random) {
        const int sent = 1 + random.below(most_shadow_samples);
        const int reached = random.below(sent + 1);
        return share_is({.sent = sent, .reached = reached}, Real(double(reached) / sent));
    }));
}

namespace {

/// The contract does not determine the error, so no suite can transform the query: these cases use
/// random queries as well.
Verdict is_positive(const ShadowRays& rays) {
    const Real got = visibility_error(rays);
    return verdict(got > 0 && got <= 1, "visibility_error(" + code(rays) +
                                            ")\n  got:      " + text(got) +
                                            "\n  expected: positive, and at most 1\n  paste:    "
                                            "CHECK(visibility_error(" +
                                            code(rays) + ") > 0);");
}

Verdict is_exchanged(const ShadowRays& rays) {
    const ShadowRays exchanged{.sent = rays.sent, .reached = rays.sent - rays.reached};
    if (const Verdict positive = is_positive(rays); !positive) return positive;
    return is(
        "visibility_error(" + code(rays) + ")", visibility_error(rays), visibility_error(exchanged),
        "close(visibility_error(" + code(rays) + "), visibility_error(" + code(exchanged) + "))");
}

/// A quarter of them reaches the light.
Verdict halves(int sent) {
    const ShadowRays few{.sent = sent, .reached = sent / 4};
    const ShadowRays many{.sent = 4 * sent, .reached = sent};
    if (const Verdict positive = is_positive(many); !positive) return positive;
    return verdict(visibility_error(many) <= Real(0.55) * visibility_error(few),
                   "visibility_error(" + code(many) +
                       ")\n  got:      " + text(visibility_error(many)) +
                       "\n  expected: about half of visibility_error(" + code(few) + "), " +
                       text(visibility_error(few)) + ", or less");
}

}  // namespace

TEST_CASE("the error is positive even if all rays agree (contract)", "[part visibility_error]") {
    for (const int sent : {1, 8, 1024})
        for (const int reached : {0, sent / 2, sent})
            CHECK(is_positive({.sent = sent, .reached = reached}));
    CHECK(for_all([](Random& random) {
        const int sent = 1 + random.below(4096);
        return is_positive({.sent = sent, .reached = random.coin() ? sent : 0});
    }));
}

TEST_CASE("the error is the same for free and blocked rays exchanged (contract)") {
    for (const int reached : {0, 1, 5, 20, 32})
        CHECK(is_exchanged({.sent = 64, .reached = reached}));
    CHECK(for_all([](Random& random) {
        const int sent = 1 + random.below(4096);
        return is_exchanged({.sent = sent, .reached = random.below(sent + 1)});
    }));
}

TEST_CASE("four times the rays halve the error at least, or nearly (contract)") {
    for (const int sent : {8, 32, 128, 512, most_shadow_samples / 4}) CHECK(halves(sent));
    CHECK(for_all([](Random& random) { return halves(8 + 4 * random.below(127)); }));
}

TEST_CASE("the estimated error and the true error (contract)") {
    CHECK(honest(-1, 1));
}

TEST_CASE(
    "the estimated error and the true error, where little of the light is hidden (contract)") {
    CHECK(honest(0.8, 1));
}
