// Stage 11, `trace`: the share of an area light that reaches a point, against CR §3.3.
//
// The ray hits the white wall at 0,0,-4. The lights at 3,0,0 and -3,0,0 are each at a cosine of
// 0.8 there: a brightness of 0.5 gives 0.4, which is 102 of 255. A card halfway to the right one,
// with an edge at y = 0, leaves half of it.
#include "tests/suites/lights.hpp"
#include "tests/suites/random_shadows.hpp"

using namespace rt;

namespace {

const std::string white_wall = "pl 0,0,-4 0,0,1 255,255,255\n";
const std::string red_right = "L 3,0,0 0.5 255,0,0 radius:0.3\n";
const std::string green_left = "L -3,0,0 0.5 0,255,0 radius:0.3\n";
const std::string half_card = "sq 1.5,1,-2 0.6,0,0.8 2 9,9,9\n";
const std::string most_hidden = "sq 1.5,0.94,-2 0.6,0,0.8 2 9,9,9\n";
const std::string whole_card = "sq 1.5,0,-2 0.6,0,0.8 1 9,9,9\n";

/// Of 102 levels, three standard deviations of independent samples, 1/2 ± 3/(2 √256).
constexpr int spread = 10;
const RenderSettings many_samples{.shadow_samples = 256};

}  // namespace

TEST_CASE("an area light without anything in the way counts whole, once (CR §3.3)",
          "[part trace]") {
    for (const int samples : {1, 2, 16, 100}) {
        const RenderSettings settings{.shadow_samples = samples};
        CHECK(shows(red_right + white_wall, {102, 0, 0}, settings));
        CHECK(shows(red_right + green_left + white_wall, {102, 102, 0}, settings));
    }
}

TEST_CASE("an area light that is hidden altogether gives nothing (CR §3.3)") {
    CHECK(shows(red_right + white_wall + whole_card, {0, 0, 0}));
    CHECK(shows(red_right + green_left + white_wall + whole_card, {0, 102, 0}));
    CHECK(shows(green_left + red_right + white_wall + whole_card, {0, 102, 0}));
    CHECK(random_lights_are_blocked(" radius:0.05"));
}

TEST_CASE("half of an area light gives half of its light (CR §3.3)") {
    CHECK(shows(red_right + white_wall + half_card, {51, 0, 0}, many_samples, spread));
    // The edge crosses the light at 0.4 of its radius: 1/4 of a disc is beyond.
    const std::string scene = red_right + white_wall;
    CHECK(shows(scene + most_hidden, {26, 0, 0}, many_samples, spread));
    CHECK(shows(scene + "sq 1.5,1.06,-2 0.6,0,0.8 2 9,9,9\n", {76, 0, 0}, many_samples, spread));
    CHECK(shows(scene + "sq 1.5,-0.94,-2 0.6,0,0.8 2 9,9,9\n", {26, 0, 0}, many_samples, spread));
    // The same with an upright edge: the light is seen from the point, not from the eye.
    for (const std::string center : {"1.9,0,-2.3", "1.1,0,-1.7"})
        CHECK(shows(scene + "sq " + center + " 0.6,0,0.8 1 9,9,9\n", {51, 0, 0}, many_samples,
                    spread));
    for (const std::string center : {"1.852,0,-2.264", "1.148,0,-1.736"})
        CHECK(shows(scene + "sq " + center + " 0.6,0,0.8 1 9,9,9\n", {26, 0, 0}, many_samples,
                    spread));
}

TEST_CASE("each light has a share of its own (CR §3.3)") {
    for (const std::string& lights : {red_right + green_left, green_left + red_right})
        CHECK(shows(lights + white_wall + half_card, {51, 102, 0}, many_samples, spread));
}

TEST_CASE("a single sample is seen or not, and --shadow-samples is their number (CR §3.3)") {
    CHECK(samples_are_whole());
    CHECK(small_shares_are_seen());
    CHECK(lights_of_any_size_are_sampled());
}

TEST_CASE("each light has samples of its own (CR §3.3)") {
    CHECK(lights_have_their_own_samples());
    CHECK(pixels_have_their_own_samples());
    CHECK(samples_are_well_spread());
}

TEST_CASE("ambient light is neither shared nor counted again (CR §3.3)") {
    const std::string ambient = "A 0.2 0,0,255\n";
    CHECK(shows(ambient + red_right + white_wall + half_card, {51, 0, 51}, many_samples, spread));
    CHECK(shows(ambient + red_right + green_left + white_wall, {102, 102, 51}));
    CHECK(shows(ambient + red_right + white_wall + whole_card, {0, 0, 51}));
}

TEST_CASE("the highlight has the same share as the rest of the light (CR §3.3)") {
    // The eye is at 0.8 of the direction of reflection.
    const std::string shining = "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:1\n";
    const std::string light = "L 3,0,0 0.5 255,255,255 radius:0.3\n";
    CHECK(shows(light + shining, {51, 51, 153}));
    CHECK(shows(light + shining + half_card, {26, 26, 77}, many_samples, spread));
    CHECK(shows(light + shining + whole_card, {0, 0, 0}));
}

TEST_CASE("the shadow of a point light is as in stage 10 (CR §3.2)") {
    const std::string red_point = "L 3,0,0 0.5 255,0,0\n";
    CHECK(shows(red_point + white_wall, {102, 0, 0}));
    CHECK(shows(red_point + white_wall + whole_card, {0, 0, 0}));
    CHECK(shows(red_point + green_left + white_wall + whole_card, {0, 102, 0}));
    CHECK(shows(green_left + red_point + white_wall + whole_card, {0, 102, 0}));
}

TEST_CASE("without a hit the pixel is black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shade_normal_shows_the_normal(11));
}

TEST_CASE("each kind of shape hides what is farther away, in any order of the file (CR §2.1)") {
    CHECK(nearest_of_each_pair_is_seen(11, "A 1 255,255,255\n", false));
}

TEST_CASE("every kind of shape casts a shadow, up to both ends of its way (CR §3.2)") {
    CHECK(every_kind_casts_a_shadow(""));
    CHECK(every_kind_casts_a_shadow(" radius:0.05"));
    CHECK(shadows_at_both_ends());
    CHECK(ceilings_leave_their_lamp());
}

TEST_CASE("the terms of all lights add up, from any eye (CR §3.1)") {
    CHECK(terms_add_up());
    CHECK(every_kind_is_lit_from_either_side(11));
}

TEST_CASE("the option --term selects a term (docs/step09_phong.md)") {
    CHECK(term_is_selected());
    CHECK(term_has_shadows());
}
