// Shares, the number of reflections, and mirrors in scenes, against CR §5.1.
#include "steps/step12_mirror/mirror.hpp"

#include "common/render/stage.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"

#include <cmath>

using namespace rt;

namespace {

Verdict worth(int bounces, int depth, Real weight, bool expected) {
    const auto word = [](bool yes) { return yes ? "true" : "false"; };
    const std::string call = "worth_reflecting(" + std::to_string(bounces) + ", " +
                             std::to_string(depth) + ", " + code(weight) + ")";
    const bool got = worth_reflecting(bounces, depth, weight);
    return verdict(got == expected, call + "\n  got:      " + word(got) +
                                        "\n  expected: " + word(expected) + "\n  paste:    CHECK(" +
                                        (expected ? "" : "!") + call + ");");
}

/// The condition that ends the trace in a scene of perfect mirrors, tested before such a scene is
/// traced.
Verdict stops_at(int depth) {
    Verdict stops;
    for (int bounces = depth; stops && bounces < depth + 4; ++bounces)
        stops = worth(bounces, depth, 1, false);
    return stops;
}

Verdict mixes(Color own, Color reflection, Real mirror, Color expected) {
    return gives("mixed(" + code(own) + ", " + code(reflection) + ", " + code(mirror) + ")",
                 mixed(own, reflection, mirror), expected);
}

/// The color from `trace`, or a failure with the sentence `what`.
Verdict sees(const std::string& what, const Scene& scene, const Ray& ray, Color expected,
             int depth = 8) {
    if (const Verdict stops = stops_at(depth); !stops) return stops;
    Context context{.settings = {.depth = depth}};
    return gives("trace(" + what + ", " + code(ray) + ") with --depth " + std::to_string(depth),
                 trace(scene, ray, context), expected);
}

/// The number of reflections that `trace` computes in a scene without lights: every ray but the
/// first is one.
Verdict reflections(const std::string& what, const Scene& scene, const Ray& ray, int expected,
                    int depth = 8) {
    if (const Verdict stops = stops_at(depth); !stops) return stops;
    Context context{.settings = {.depth = depth}};
    static_cast<void>(trace(scene, ray, context));
    const auto got = context.rays - 1;
    return verdict(got == expected, "the reflections of trace(" + what + ", " + code(ray) +
                                        ") with --depth " + std::to_string(depth) +
                                        "\n  got:      " + std::to_string(got) +
                                        "\n  expected: " + std::to_string(expected));
}

const Color red{1, Real(0.25), 0};
const Color blue{0, Real(0.25), 1};
const Ambient everywhere{.ratio = 1};  // a lit surface shows its own color

/// Two facing walls, four apart, a red and a blue one. A ray that runs across is reflected to and
/// fro.
Scene facing_walls(Real mirror) {
    Scene scene;
    scene.ambient = everywhere;
    scene.planes.push_back({.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}},
                            .material = {.color = red, .mirror = mirror}});
    scene.planes.push_back({.shape = {.point = {-2, 0, 0}, .normal = {1, 0, 0}},
                            .material = {.color = blue, .mirror = mirror}});
    return scene;
}

const Ray across{.origin = {1, 0, 0}, .direction = {1, 0, 0}};
const Ray aslant{.origin = {1, 0, 0}, .direction = {1, Real(0.5), Real(0.25)}};

/// The geometric sum: each mirror's own share of the weight that the mirrors before it left.
Color facing_sum(Real mirror, int depth) {
    Color sum(0);
    Real weight = 1;
    for (int wall = 0; wall <= depth; ++wall, weight *= mirror)
        sum += weight * (1 - mirror) * (wall % 2 == 0 ? red : blue);
    return sum;
}

/// A mirror all around, of radius √2, in which a ray along a side of the inscribed square returns
/// after four reflections; and a red sphere on the first side, behind the ray's start.
Scene inside_of_mirror() {
    Scene scene;
    scene.ambient = everywhere;
    scene.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = std::sqrt(Real(2))},
                             .material = {.color = blue, .mirror = 1}});
    scene.spheres.push_back({.shape = {.center = {Real(-0.5), -1, 0}, .radius = Real(0.25)},
                             .material = {.color = red}});
    return scene;
}

const Ray round_the_square{.origin = {0, -1, 0}, .direction = {1, 0, 0}};

}  // namespace

TEST_CASE("the surface's own part and the reflected part sum to one (contract)", "[part mixed]") {
    const Color own{1, Real(0.5), 0};
    const Color reflection{0, Real(0.25), Real(0.5)};
    CHECK(mixes(own, reflection, 0, own));
    CHECK(mixes(own, reflection, 1, reflection));
    CHECK(mixes(own, reflection, Real(0.5), {Real(0.5), Real(0.375), Real(0.25)}));
    CHECK(mixes(own, reflection, Real(0.75), {Real(0.25), Real(0.3125), Real(0.375)}));
    CHECK(for_all([](Random& random) {  // a little of one of them
        const Color surface = abs(random.point(1));
        const Color seen = abs(random.point(1));
        const Real little = std::ldexp(Real(1), -3 - random.below(8));
        const Real mirror = random.coin() ? little : 1 - little;
        return mixes(surface, seen, mirror, surface + mirror * (seen - surface));
    }));
}

TEST_CASE("a mirror in a room of its own color has that color (contract)") {
    CHECK(mixes(Color(0), Color(4), Real(0.25), Color(1)));  // and has another one in the mirror
    CHECK(for_all([](Random& random) {
        const Color color = abs(random.point(1));
        return mixes(color, color, random.between(0, 1), color);
    }));
}

TEST_CASE("reflections of colors brighter than white (contract)") {
    CHECK(mixes(Color(0), Color(4), Real(0.25), Color(1)));
    CHECK(mixes(Color(8), Color(0), Real(0.75), Color(2)));
}

TEST_CASE("reflections stop at a depth of 0, 1, 2, 8 and 1000 (contract)",
          "[part worth_reflecting]") {
    for (const int depth : {0, 1, 2, 8, 1000}) CHECK(stops_at(depth));
}

TEST_CASE("one bounce is one reflection (erratum 30, CR §2.1)") {
    CHECK(worth(0, 1, 1, true));
    CHECK(worth(1, 1, 1, false));
    CHECK(worth(1, 2, 1, true));
    CHECK(worth(2, 2, 1, false));
    Verdict all;
    for (int depth = 1; all && depth <= 20; ++depth)
        for (int bounces = 0; all && bounces < depth; ++bounces)
            all = worth(bounces, depth, 1, true);
    CHECK(all);
    CHECK(for_all([](Random& random) {
        const int depth = 1 + random.below(100000);
        return worth(random.below(depth), depth, 1, true);
    }));
}

TEST_CASE("a weight of less than 1/512 is not worth a ray (contract)") {
    CHECK(worth(0, 8, Real(1) / 256, true));
    CHECK(worth(7, 8, Real(1) / 512, true));
    CHECK(worth(0, 8, Real(1) / 513, false));
    CHECK(worth(0, 8, Real(1) / 1024, false));
    CHECK(worth(0, 8, 0, false));
    CHECK(worth(0, 1000, Real(0.001), false));
    CHECK(worth(0, 8, Real(0.00195), false));
    CHECK(for_all([](Random& random) {
        const Real little = std::ldexp(Real(1), -1 - random.below(20));
        const bool more = random.coin();
        return worth(0, 8, (more ? 1 + little : 1 - little) / 512, more);
    }));
}

TEST_CASE("between two facing mirrors a ray is reflected --depth times (CR §5.1)",
          "[part together]") {
    Verdict perfect;
    Verdict dim;
    for (const int depth : {0, 1, 2, 3, 7, 8, 30}) {
        if (perfect) perfect = reflections("two mirrors", facing_walls(1), across, depth, depth);
        if (dim) dim = reflections("two mirrors", facing_walls(Real(0.875)), aslant, depth, depth);
    }
    CHECK(perfect);
    CHECK(dim);
}

TEST_CASE("two facing mirrors show the geometric sum of their shares (CR §5.1)") {
    Verdict sums;
    for (const int depth : {0, 1, 2, 3, 7, 8}) {
        for (const Real mirror : {Real(0.5), Real(0.75), Real(0.9), Real(1)}) {  // of 1: black
            const Scene walls = facing_walls(mirror);
            const Color sum = facing_sum(mirror, depth);
            if (sums) sums = sees("two mirrors", walls, across, sum, depth);
            if (sums) sums = sees("two mirrors", walls, aslant, sum, depth);
        }
    }
    CHECK(sums);
    // Written out: ½ red, ¼ blue and ⅛ red.
    CHECK(sees("two mirrors", facing_walls(Real(0.5)), across,
               {Real(0.625), Real(0.21875), Real(0.25)}, 2));
}

TEST_CASE(
    "the number of reflections between mirrors with shares of 0.1, 0.125 and 0.5 (contract)") {
    // A power of two equals the bound exactly: (1/8)³ is 1/512, and (1/2)⁹ too.
    CHECK(reflections("two mirrors", facing_walls(Real(0.1)), across, 2));
    CHECK(reflections("two mirrors", facing_walls(Real(0.1)), across, 2, 1000));
    CHECK(reflections("two mirrors", facing_walls(Real(0.125)), across, 3, 1000));
    CHECK(reflections("two mirrors", facing_walls(Real(0.5)), across, 9, 1000));
    CHECK(sees("two mirrors", facing_walls(Real(0.1)), across, facing_sum(Real(0.1), 2), 1000));
}

TEST_CASE("the number of reflected rays of a surface without a mirror part is 0 (contract)") {
    CHECK(reflections("two walls", facing_walls(0), across, 0));
    CHECK(sees("two walls", facing_walls(0), across, red));
}

TEST_CASE("the number of shadow rays of a perfect mirror is 0 (contract)") {
    Scene scene = facing_walls(1);
    scene.lights.push_back({.position = {0, 0, 1}});
    CHECK(reflections("two mirrors and a light", scene, across, 3, 3));
}

TEST_CASE("a mirror whose reflected ray misses has its own share of color (CR §5.1)") {
    Scene scene;
    scene.ambient = everywhere;
    scene.planes.push_back({.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}},
                            .material = {.color = red, .mirror = Real(0.75)}});
    CHECK(reflections("one mirror", scene, aslant, 1));
    CHECK(sees("one mirror", scene, aslant, Real(0.25) * red));
}

TEST_CASE(
    "in a mirror all around, a ray goes round the square, and sees behind its start (CR §5.1)") {
    const Scene scene = inside_of_mirror();
    CHECK(sees("a mirror all around", scene, round_the_square, Color(0), 0));
    CHECK(sees("a mirror all around", scene, round_the_square, Color(0), 3));
    CHECK(reflections("a mirror all around", scene, round_the_square, 3, 3));
    CHECK(sees("a mirror all around", scene, round_the_square, red, 4));
    CHECK(sees("a mirror all around", scene, round_the_square, red, 8));
    CHECK(reflections("a mirror all around", scene, round_the_square, 4, 8));
}

TEST_CASE("a wall is lit, and lit it is seen in a mirror that is lit (CR §3.1, §5.1)") {
    // Down at 45° onto a floor that is half a mirror, and up to a wall. The light is above the
    // floor's point: its cosine there is 1, and at the wall, 2 down and 2 along, 1/√2.
    Scene scene;
    scene.lights.push_back({.position = {0, 4, 0}, .brightness = Real(0.5)});
    scene.planes.push_back(
        {.shape = {.point = {0, 0, 0}}, .material = {.color = red, .mirror = Real(0.5)}});
    scene.planes.push_back(
        {.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}}, .material = {.color = blue}});
    const Ray down{.origin = {-1, 1, 0}, .direction = {1, -1, 0}};
    const Color floor = Real(0.5) * red;
    const Color wall = Real(0.5) / std::sqrt(Real(2)) * blue;
    CHECK(sees("a floor and a wall", scene, down, Real(0.5) * floor + Real(0.5) * wall));
    CHECK(sees("a floor and a wall", scene, down, Real(0.5) * floor, 0));
}

TEST_CASE("the picture of the stage (CR §5.1)") {
    REQUIRE(stops_at(8));
    CHECK(picture_matches("step12_mirror", {.every = 8}));
}
