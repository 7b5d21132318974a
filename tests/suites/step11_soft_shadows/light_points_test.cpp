// The points of a light against CR §3.3 and erratum 16.
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "tests/kit/light.hpp"
#include "tests/suites/step11_soft_shadows/share_of_light.hpp"

#include "common/contract/light_points.hpp"
#include "common/render/sampling.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

std::string call(const Light& light, Vec3 from, Vec2 sample) {
    return "sample_light(" + code(light) + ",\n              Vec3" + code(from) + ", Vec2{" +
           code(sample.x) + ", " + code(sample.y) + "})";
}

/// The light's point, with a `tolerance` relative to the light's distance.
Verdict aims_at(const Light& light, Vec3 from, Vec2 sample, Vec3 expected) {
    const Vec3 got = sample_light(light, from, sample);
    return verdict(close(got, expected),
                   call(light, from, sample) + "\n  got:      " + text(got) +
                       "\n  expected: " + text(expected) + "\n  paste:    CHECK(aims_at(" +
                       code(light) + ", Vec3" + code(from) + ", Vec2{" + code(sample.x) + ", " +
                       code(sample.y) + "}, " + code(expected) + "));");
}

/// The point is on the sphere, on the visible side: within the circle of the tangents.
Verdict aims_at_what_is_seen(const Light& light, Vec3 from, Vec2 sample) {
    const Exact point = sample_light(light, from, sample);
    const Exact center = light.position;
    const Exact away = Exact(from) - center;
    const double radius = light.radius;
    const double slack = double(tolerance) * (length(away) + length(Exact(from)));
    const Exact on_light = point - center;
    const std::string asked = call(light, from, sample) + "\n  got:      " + text(Vec3(point));
    const std::string paste = "\n  paste:    CHECK(aims_at_what_is_seen(" + code(light) + ", Vec3" +
                              code(from) + ", Vec2{" + code(sample.x) + ", " + code(sample.y) +
                              "}));";
    if (!(std::abs(length(on_light) - radius) <= slack))
        return verdict(false, asked + ", " + text(Real(length(on_light))) +
                                  " from the light's center\n  expected: a point of the light's "
                                  "surface, at its radius, " +
                                  text(light.radius) + paste);
    const double towards = dot(on_light, away / length(away));
    const double least = radius * radius / length(away);
    return verdict(towards >= least - slack,
                   asked +
                       ", on the far side of the light\n  expected: a point that can be seen from "
                       "there: at least " +
                       text(Real(least)) + " from the center towards it, not " +
                       text(Real(towards)) + paste);
}

/// The position of a point in the visible cap of the light: both numbers are uniform in 0 to 1 if
/// the directions are uniform in the cone of the light. `turn` is relative to any direction.
struct Seen {
    double ring;  ///< (1 − cos θ) / (1 − cos θ_max), θ from the light's center
    double turn;
};

Seen seen(const Light& light, Vec3 from, Vec3 point) {
    const Exact axis = normalize(Exact(light.position) - Exact(from));
    const Exact direction = normalize(Exact(point) - Exact(from));
    const double sine = light.radius / length(Exact(light.position) - Exact(from));
    const double largest = sine * sine / (1 + std::sqrt(1 - sine * sine));
    const Exact aside = direction - axis;  // ‖aside‖² = 2 (1 − cos θ), without cancellation
    const Exact some = std::abs(axis.x) < 0.5 ? Exact(1, 0, 0) : Exact(0, 1, 0);
    const Exact x = normalize(cross(some, axis));
    const double angle = std::atan2(dot(aside, cross(axis, x)), dot(aside, x));
    return {.ring = dot(aside, aside) / 2 / largest, .turn = angle / (2 * exact_pi) + 0.5};
}

/// For 4096 well-spread samples, each of 8 rings and 8 sectors of equal solid angle contains 64
/// points, within 16: 4 standard deviations of points that are twice as uneven as the samples. And
/// each of 128 rings, and of 128 sectors, contains a point: of independent points, 32 are in each,
/// and none with a probability of 10^-14.
Verdict points_are_uniform(const Light& light, Vec3 from, std::uint32_t seed) {
    constexpr int samples = 4096;
    std::array<std::array<int, 8>, 8> counts{};
    std::array<bool, 128> is_ring_hit{};
    std::array<bool, 128> is_sector_hit{};
    const std::vector<Vec3> points = light_points(light, from, seed, samples);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const auto [ring, turn] = seen(light, from, points[i]);
        if (!(ring < 1.01))  // NaN too
            return aims_at_what_is_seen(light, from, spread_sample(i, seed));
        const auto box = [](double x, double count) {
            return std::size_t(std::clamp(x * count, 0.0, count - 1));
        };
        ++counts[box(ring, 8)][box(turn, 8)];
        is_ring_hit[box(ring, 128)] = true;
        is_sector_hit[box(turn, 128)] = true;
    }
    const std::string asked = "sample_light(" + code(light) + ",\n              Vec3" + code(from) +
                              ", sample) for " + std::to_string(samples) +
                              " samples: the light as seen from there, cut into ";
    const std::string paste = "\n  paste:    CHECK(points_are_uniform(" + code(light) + ", Vec3" +
                              code(from) + ", " + std::to_string(seed) + "));";
    for (std::size_t ring = 0; ring < 8; ++ring)
        for (const int count : counts[ring])
            if (std::abs(count - 64) > 16)
                return verdict(
                    false,
                    asked + "8 rings of 8 pieces of equal solid angle\n  got:      " +
                        std::to_string(count) + " points in a piece of " +
                        (ring == 0 ? "the innermost ring"
                                   : "ring " + std::to_string(ring + 1) + " from the middle") +
                        "\n  expected: 64 in each, give or take 16" + paste);
    for (std::size_t i = 0; i < 128; ++i)
        if (!is_ring_hit[i] || !is_sector_hit[i])
            return verdict(false, asked + "128 " + (is_ring_hit[i] ? "sectors" : "rings") +
                                      " of equal solid angle\n  got:      none in number " +
                                      std::to_string(i + 1) +
                                      (is_ring_hit[i] ? "" : " from the middle") +
                                      "\n  expected: about 32 in each" + paste);
    return {};
}

Vec2 draw_sample(Random& random) {
    const Real x = random.between(0, Real(0.9999));
    return {x, random.between(0, Real(0.9999))};
}

/// A light from a twentieth of its radius above its surface to ten radii away, or one in four times
/// to 400.
Light draw_light(Random& random, Vec3 from) {
    const Real radius = random.between(Real(0.5), 2);
    const Vec3 way = random.direction();
    const Real radii =
        random.below(4) > 0 ? random.between(Real(1.05), 10) : random.between(10, 400);
    return {.position = from + radius * radii * way, .radius = radius};
}

const Light above{.position = {0, 4, 0}, .radius = 2};

}  // namespace

TEST_CASE("the mean of the points is on the line to the light's center (CR §3.3, erratum 16)",
          "[part sample_light, CR's cube]") {
    CHECK(verdict(sample_light(above, {0, 0, 0}, {Real(0.9), Real(0.1)}) !=
                      sample_light(above, {0, 0, 0}, {Real(0.9), Real(0.6)}),
                  "Every sample is aimed at one point."));
    const auto property = [](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        Exact sum(0);
        constexpr int samples = 1024;
        for (const Vec3& point : light_points(light, from, 5, samples))
            sum += Exact(point) - Exact(light.position);
        const Exact mean = sum / double(samples);
        const Exact axis = normalize(Exact(from) - Exact(light.position));
        const double aside = length(mean - dot(mean, axis) * axis) / light.radius;
        return verdict(aside < 0.02, "The mean of sample_light(" + code(light) +
                                         ",\n              Vec3" + code(from) + ", sample) over " +
                                         std::to_string(samples) +
                                         " samples\n  got:      " + text(Real(aside)) +
                                         " of the radius off the line to the light's center\n"
                                         "  expected: on it, to 0.02");
    };
    CHECK(for_all(property, 40));
}

TEST_CASE("another sample is another point (CR §3.3)") {
    CHECK(for_all([](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        const Vec3 first = sample_light(light, from, {Real(0.25), Real(0.125)});
        const Vec3 second = sample_light(light, from, {Real(0.75), Real(0.625)});
        return verdict(distance(first, second) > Real(0.01) * light.radius,
                       call(light, from, {Real(0.25), Real(0.125)}) + "\n  got:      " +
                           text(first) + "\n  expected: not what the sample (0.75, 0.625) gives");
    }));
}

TEST_CASE("the same sample gives the same point in every call (contract)") {
    CHECK(for_all([](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        const Vec2 sample = draw_sample(random);
        return aims_at(light, from, sample, sample_light(light, from, sample));
    }));
}

TEST_CASE("from inside the light it is its center (contract)") {
    const Vec2 sample(Real(0.375), Real(0.625));
    CHECK(aims_at(above, {0, 4, 0}, sample, above.position));
    CHECK(aims_at(above, {1, 4, 0}, sample, above.position));
    CHECK(aims_at(above, {0, Real(2.125), 0}, sample, above.position));
    CHECK(for_all([](Random& random) {
        const Light light{.position = random.point(5), .radius = random.between(Real(0.5), 2)};
        const Vec3 from =
            light.position + light.radius * random.between(0, Real(0.99)) * random.direction();
        return aims_at(light, from, draw_sample(random), light.position);
    }));
}

TEST_CASE("a light without a size is aimed at where it is (contract)") {
    CHECK(for_all([](Random& random) {
        const Light light{.position = random.point(5)};
        return aims_at(light, random.point(5), draw_sample(random), light.position);
    }));
}

TEST_CASE("just outside the light, the point is still on it (contract)",
          "[part sample_light, a disc][exact]") {
    for (const Real above_surface : {Real(0), 4 * epsilon, 64 * epsilon, Real(0.001)}) {
        const Vec3 from(0, 4 - 2 * (1 + above_surface), 0);
        for (const Real x : {Real(0), Real(0.5), Real(0.999)}) {
            const Vec3 got = sample_light(above, from, {x, Real(0.25)});
            if (x > 0 && above_surface > 64 * epsilon)  // closer points may all be equal
                CHECK(got != sample_light(above, from, {x, Real(0.75)}));
            // the light's center is accepted on the surface
            const Real off = distance(got, above.position);
            CHECK(verdict(off <= 2 + 2 * tolerance, call(above, from, {x, Real(0.25)}) +
                                                        "\n  got:      " + text(got) +
                                                        "\n  expected: a point of the light"));
        }
    }
    CHECK(for_all([](Random& random) {
        const Light light{.position = random.point_in_eighths(3), .radius = random.eighths(1, 3)};
        const Real above_surface = random.between(Real(0.001), Real(0.01));
        const Vec3 from = light.position + light.radius * (1 + above_surface) * random.direction();
        const Real x = random.between(Real(0.25), Real(0.999));
        const Vec3 got = sample_light(light, from, {x, Real(0.25)});
        const Real off = distance(got, light.position);
        return verdict(off <= light.radius * (1 + tolerance) &&
                           got != sample_light(light, from, {x, Real(0.75)}),
                       call(light, from, {x, Real(0.25)}) + "\n  got:      " + text(got) +
                           "\n  expected: a point of the light, another one for {x, 0.75}");
    }));
}

TEST_CASE("the points on a light far away are uniform over its disc (CR §3.3)") {
    CHECK(points_are_uniform({.position = {0, 0, 0}, .radius = 1}, {0, 100, 0}, 8));
    CHECK(points_are_uniform({.position = {1, 2, 3}, .radius = 2}, {121, 2, 163}, 9));
    CHECK(points_are_uniform({.position = {3, 2, 1}, .radius = Real(0.5)}, {123, 162, 1}, 10));
}

TEST_CASE("the point is on the light, on the side that is seen (CR §3.3, erratum 16)",
          "[part sample_light, the visible ball][3 points]") {
    CHECK(aims_at_what_is_seen({.position = {5, 5, 5}, .radius = 1}, {0, 0, 0}, {Real(0.5), 0}));
    CHECK(aims_at_what_is_seen({.position = {0, 0, -3}, .radius = 2}, {0, 0, 0}, {0, 0}));
    CHECK(aims_at_what_is_seen(above, {0, 0, 0}, {Real(0.999), Real(0.25)}));
    const Real farthest = std::min(Real(0.25) / tolerance, std::ldexp(Real(1), 20));
    for (const Real distance : {Real(25), Real(100), farthest})  // where a disc looks alike
        CHECK(aims_at_what_is_seen({.position = {0, 0, distance}, .radius = 1}, {0, 0, 0},
                                   {Real(0.0625), Real(0.25)}));
    CHECK(for_all([](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        return aims_at_what_is_seen(light, from, draw_sample(random));
    }));
    CHECK(for_all(
        [](Random& random) {
            // Close to the light and at its rim, where the square of a cosine may round below 0.
            const Vec3 from = random.point(5);
            const Real radius = random.between(Real(0.5), 2);
            const Vec3 way = radius * random.between(Real(1.001), Real(1.05)) * random.direction();
            const Light light{.position = from + way, .radius = radius};
            return aims_at_what_is_seen(light, from, {1 - unit_roundoff, random.between(0, 1)});
        },
        1000));
}

TEST_CASE("the points are uniform over the light's solid angle (CR §3.3)") {
    CHECK(points_are_uniform(above, {0, 0, 0}, 1));          // cos θ_max = √3 / 2
    CHECK(points_are_uniform(above, {0, Real(1.9), 0}, 2));  // almost touching
    CHECK(
        points_are_uniform({.position = {3, 4, 0}, .radius = 4}, {0, 0, 0}, 3));  // sin θ_max = 0.8
    CHECK(points_are_uniform({.position = {0, 0, 100}, .radius = 1}, {0, 0, 0}, 4));
    const auto property = [](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        return points_are_uniform(light, from, draw_seed(random));
    };
    CHECK(for_all(property, 40));
}

TEST_CASE("the points on a light with a very small solid angle are uniform (contract)", "[exact]") {
    // 1 − sin² rounds to 1: with a cosine computed from it, 1 − cos is 0, and all points are one.
    const Real distance = 2 / std::sqrt(unit_roundoff);
    CHECK(points_are_uniform({.position = {0, 0, 0}, .radius = 1}, {0, distance, 0}, 6));
    CHECK(points_are_uniform({.position = {0, 0, 0}, .radius = 1}, {0, 0, distance}, 7));
}

TEST_CASE("a light very far, or very small, is aimed at (contract)", "[exact]") {
    const Real far = std::ldexp(Real(1), 40);
    const Vec2 sample(Real(0.375), Real(0.625));
    CHECK(aims_at_what_is_seen({.position = {0, far, 0}, .radius = 1}, {0, 0, 0}, sample));
    CHECK(aims_at_what_is_seen({.position = {far, far, 0}, .radius = far / 2}, {0, 0, 0}, sample));
    CHECK(aims_at_what_is_seen({.position = {0, 4, 0}, .radius = 1 / far}, {0, 0, 0}, sample));
    CHECK(
        aims_at_what_is_seen({.position = {0, 3 / far, 0}, .radius = 1 / far}, {0, 0, 0}, sample));
    // The square of radius / distance is a number in float, too.
    CHECK(for_all([far](Random& random) {
        const Vec3 way = random.eighths(3, 8) * random.direction();
        const Real radius = random.eighths(1, 2);
        const Light distant{.position = far * way, .radius = radius};
        const Light small{.position = (random.coin() ? 1 : 1 / far) * way, .radius = radius / far};
        return aims_at_what_is_seen(random.coin() ? distant : small, Vec3(0), draw_sample(random));
    }));
}

TEST_CASE("on average the visible share is that of the solid angle, for any occluder (CR §3.3)") {
    const auto property = [](Random& random) {
        const Vec3 from = random.point(5);
        const Light light = draw_light(random, from);
        // A plane through the point, turned so that it cuts the light.
        const Exact axis = normalize(Exact(light.position) - Exact(from));
        const double half_angle = std::asin(light.radius / distance(light.position, from));
        const Exact across = normalize(cross(axis, Exact(random.direction()) + Exact(0, 0, 2)));
        const double offset = half_angle * double(random.between(Real(-0.95), Real(0.95)));
        const Exact normal = std::cos(offset) * across + std::sin(offset) * axis;
        const std::uint32_t seed = draw_seed(random);
        double sum = 0;
        for (std::uint32_t i = 0; i < 64; ++i) {
            ShadowRays rays{.sent = 256};
            for (const Vec3& point : light_points(light, from, seed + i, rays.sent))
                if (dot(Exact(point) - Exact(from), normal) > 0) ++rays.reached;
            sum += double(rays.reached) / rays.sent / 64;
        }
        const double expected = share_beside_plane(light, from, normal);
        return verdict(std::abs(sum - expected) < share_bound,
                       "sample_light(" + code(light) + ",\n              Vec3" + code(from) +
                           ", sample): the share of the points on one side of a plane\n"
                           "  got:      " +
                           text(Real(sum)) + "\n  expected: " + text(Real(expected)) +
                           ", the share of the solid angle, give or take 0.0102");
    };
    CHECK(for_all(property, 30));
}
