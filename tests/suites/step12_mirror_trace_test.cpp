// Stage 12, `trace`: what a mirror shows, against CR §5.1.
//
// The ray hits a mirror at 0,0,-4, which faces the eye. The wall behind the eye, at z = 6, is what
// it shows.
#include "tests/suites/lights.hpp"
#include "tests/suites/mirrors.hpp"

using namespace rt;

namespace {

const std::string bright = "A 1 255,255,255\n";
const std::string red_wall_behind = "pl 0,0,6 0,0,-1 255,0,0\n";

std::string mirror(const std::string& share, const std::string& color = "255,255,255") {
    return "pl 0,0,-4 0,0,1 " + color + " mirror:" + share + "\n";
}

/// Passes if a perfect mirror with this normal, which the ray hits at 0,0,-4, shows the color.
Verdict reflects(const std::string& normal, const std::string& others, Rgb expected,
                 const RenderSettings& settings = {}) {
    return shows(bright + "pl 0,0,-4 " + normal + " 255,255,255 mirror:1\n" + others, expected,
                 settings);
}

/// The mirror's color and its own, of random colors and shares.
Verdict random_shares_are_mixed() {
    return for_all(
        [](Random& random) {
            const int percent = random.below(101);
            const Rgb own = draw_color(random);
            const Rgb seen = draw_color(random);
            const Real share = Real(percent) / 100;
            Rgb expected;
            for (std::size_t i = 0; i < 3; ++i)
                expected[i] =
                    std::uint8_t(share * Real(seen[i]) + (1 - share) * Real(own[i]) + Real(0.5));
            return shows(bright + mirror(std::to_string(percent * 0.01), scene_color(own)) +
                             "pl 0,0,6 0,0,-1 " + scene_color(seen) + "\n",
                         expected);
        },
        40);
}

}  // namespace

TEST_CASE("a perfect mirror shows what it faces, and nothing of its own (CR §5.1)",
          "[part trace]") {
    CHECK(shows(bright + mirror("1") + red_wall_behind, {255, 0, 0}));
    CHECK(shows(bright + mirror("1") + red_wall_behind + "sp 0,0,-8 2 0,255,0\n", {255, 0, 0}));
    CHECK(shows(bright + mirror("1") + "sp 0,0,6 2 0,255,0\n", {0, 255, 0}));
}

TEST_CASE("a mirror's share is that of what it shows, and the rest is its own color (CR §5.1)") {
    CHECK(shows(bright + mirror("0.25") + red_wall_behind, {255, 191, 191}));
    CHECK(shows(bright + mirror("0.8", "0,0,255") + red_wall_behind, {204, 0, 51}));
    CHECK(shows(bright + mirror("0.25"), {191, 191, 191}));
    CHECK(shows(bright + mirror("0") + red_wall_behind, {255, 255, 255}));
    CHECK(random_shares_are_mixed());
}

TEST_CASE("a mirror that is turned shows what lies where it sends the ray (CR §5.1)") {
    const std::string turned = "pl 0,0,-4 0,0.70710678,0.70710678 255,255,255 mirror:1\n";
    CHECK(shows(bright + turned + "pl 0,5,0 0,-1,0 0,255,0\n" + red_wall_behind, {0, 255, 0}));
    CHECK(shows(bright + turned + "pl 0,9,0 0,-1,0 0,0,255\nsp 0,5,-4 1 0,255,0\n", {0, 255, 0}));
}

TEST_CASE("a mirror shows black, or the sky, where its ray misses (CR §5.1)") {
    CHECK(mirrors_show_black_or_sky());
}

TEST_CASE("where the reflections end, it is black (CR §5.1)") {
    const std::string sky = "sky 255,255,255 255,255,255\n";
    const RenderSettings none{.depth = 0};
    for (const std::string normal :
         {"0.70710678,0,0.70710678", "-0.70710678,0,0.70710678", "0,0.70710678,0.70710678",
          "0,-0.70710678,0.70710678", "0,0,1"}) {
        CHECK(reflects(normal, "", {0, 0, 0}, none));
        CHECK(reflects(normal, sky, {0, 0, 0}, none));
    }
    // A share of 0.25 of it, and after one reflection.
    CHECK(shows(sky + bright + mirror("0.25"), {191, 191, 191}, none));
    CHECK(shows(sky + bright + mirror("1") + "pl 0,0,6 0,0,-1 255,0,0 mirror:1\n", {0, 0, 0},
                {.depth = 1}));
}

TEST_CASE("each kind of shape is a mirror, from either side (CR §5.1)") {
    CHECK(every_kind_is_a_mirror(12));
}

TEST_CASE("a mirror's own color may be brighter than white before its share is taken (CR §5.1)") {
    const std::string light = "L 0,0,0 0.6 255,255,255\n";
    CHECK(shows(bright + light + mirror("0.5"), {204, 204, 204}));
    CHECK(shows(bright + light + mirror("0.5") + "sp 0,0,6 2 0,255,0\n", {204, 255, 204}));
}

TEST_CASE("each ray of a picture has its own reflections (CR §5.1)") {
    CHECK(for_all(
        [](Random& random) {
            const Rgb color = draw_color(random);
            const std::string wall_behind = "pl 0,0,6 0,0,-1 " + scene_color(color) + "\n";
            Rgb mostly_white;
            for (std::size_t i = 0; i < 3; ++i)
                mostly_white[i] = std::uint8_t(Real(239.5625) + Real(color[i]) / 16);
            Verdict all =
                shows_in_every_pixel(bright + mirror("1") + wall_behind, color, {.depth = 1});
            keep_first(all,
                       shows_in_every_pixel(bright + mirror("0.0625") + wall_behind, mostly_white));
            return all;
        },
        2));
}

TEST_CASE("a mirror shows the closest of what it faces (CR §5.1)") {
    CHECK(shows(bright + mirror("1") + red_wall_behind + "sp 0,0,3 2 0,255,0\n", {0, 255, 0}));
    CHECK(shows(bright + "sp 0,0,3 2 0,255,0\n" + red_wall_behind + mirror("1"), {0, 255, 0}));
    CHECK(mirrors_show_what_is_close());
}

TEST_CASE("what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)") {
    const std::string light = "L 0,3,2 0.5 255,255,255\n";  // at a cosine of 0.8 for the wall
    const std::string white_wall = "pl 0,0,6 0,0,-1 255,255,255\n";
    CHECK(shows(light + mirror("1") + white_wall, {102, 102, 102}));
    CHECK(shows(light + mirror("1") + white_wall + "sp 0,1.5,4 0.2 9,9,9\n", {0, 0, 0}));
    CHECK(shows(light + mirror("1") + red_wall_behind, {102, 0, 0}));
    CHECK(mirrors_show_all_terms());
    CHECK(mirrors_show_soft_shadows());
}

TEST_CASE("a mirror does not show itself (CR §5.1)") {
    CHECK(mirrors_do_not_show_themselves());
}

TEST_CASE("a mirror shows what another mirror shows (CR §5.1)") {
    // Down at the first, back at the second: the ray ends at the green wall on the left.
    const std::string first = "pl 0,0,-4 0,-0.70710678,0.70710678 255,255,255 mirror:1\n";
    const std::string second = "pl 0,-5,0 -0.70710678,0.70710678,0 255,255,255 mirror:1\n";
    CHECK(shows(bright + first + second + "pl -7,0,0 1,0,0 0,255,0\n", {0, 255, 0}));
    CHECK(shows(bright + first + "pl 0,-5,0 -0.70710678,0.70710678,0 0,0,255 mirror:0.5\n" +
                    "pl -7,0,0 1,0,0 0,255,0\n",
                {0, 128, 128}));
    CHECK(mirrors_show_mirrors(12));
}

TEST_CASE("two mirrors that face each other end, and give no more light than there is (CR §5.1)") {
    const std::string second = "pl 0,0,6 0,0,-1 255,0,0 mirror:0.5\n";
    // 1/2 + 1/8 + 1/32 + … = 2/3 is blue, 1/4 + 1/16 + … = 1/3 is red.
    CHECK(shows(bright + mirror("0.5", "0,0,255") + second, {85, 0, 170}, {}, 2));
    CHECK(shows(bright + mirror("1") + "pl 0,0,6 0,0,-1 255,255,255 mirror:1\n", {0, 0, 0}));
    CHECK(shows(bright + mirror("0.75") + "pl 0,0,6 0,0,-1 255,255,255 mirror:0.75\n",
                {255, 255, 255}, {.depth = 100}, 2));
}

TEST_CASE("the option --depth is the largest number of reflections (CR §5.1)") {
    CHECK(reflections_end());
}

TEST_CASE(
    "a reflection of a weight below 1/512 is black, however many mirrors made it (contract)") {
    CHECK(weak_reflections_are_black());
}

TEST_CASE("without a hit the pixel is black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shade_normal_shows_the_normal(12));
    CHECK(reflects("0,0.70710678,0.70710678", "", {0, 180, 180}, {.shading = Shading::normal}));
}

TEST_CASE("each kind of shape hides what is farther away, in any order of the file (CR §2.1)") {
    CHECK(nearest_of_each_pair_is_seen(12, bright, false));
}

TEST_CASE("every kind of shape casts a shadow, up to both ends of its way (CR §3.2)") {
    CHECK(every_kind_casts_a_shadow(""));
    CHECK(every_kind_casts_a_shadow(" radius:0.05"));
    CHECK(shadows_at_both_ends());
    CHECK(ceilings_leave_their_lamp());
    CHECK(area_lights_are_sampled());
}

TEST_CASE("the terms of all lights add up, from any eye (CR §3.1)") {
    CHECK(terms_add_up());
    CHECK(every_kind_is_lit_from_either_side(12));
}

TEST_CASE("the option --term selects a term (docs/step09_phong.md)") {
    CHECK(term_is_selected());
}
