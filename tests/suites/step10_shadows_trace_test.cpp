// Stage 10, `trace`: which light a shape takes away, against CR §3.2 and M1's exercise.
//
// The ray hits the white wall at 0,0,-4. The lights at 3,0,0 and -3,0,0 are each at a cosine of
// 0.8 there: a brightness of 0.5 gives 0.4, which is 102 of 255. Halfway to them are 1.5,0,-2 and
// -1.5,0,-2.
#include "tests/kit/picture.hpp"
#include "tests/suites/lights.hpp"
#include "tests/suites/random_shadows.hpp"

using namespace rt;

namespace {

const std::string white_wall = "pl 0,0,-4 0,0,1 255,255,255\n";
const std::string red_right = "L 3,0,0 0.5 255,0,0\n";
const std::string green_left = "L -3,0,0 0.5 0,255,0\n";
const std::string ball_on_the_right = "sp 1.5,0,-2 0.2 9,9,9\n";
const std::string ball_on_the_left = "sp -1.5,0,-2 0.2 9,9,9\n";

/// A wall that crosses the ray at any angle is lit by a light at the eye.
Verdict slanted_walls_are_lit() {
    return for_all(
        [](Random& random) {
            const Vec3 normal(random.below(19) - 9, random.below(19) - 9, 1 + random.below(9));
            const auto coordinate = [&] { return std::to_string(random.below(1000) * 0.001); };
            const std::string point = coordinate() + "," + coordinate() + ",-20";
            const auto level = std::uint8_t(Real(102) * normal.z / length(normal) + Real(0.5));
            return shows("L 0,0,0 0.4 255,255,255\npl " + point + " " +
                             std::to_string(int(normal.x)) + "," + std::to_string(int(normal.y)) +
                             "," + std::to_string(int(normal.z)) + " 255,255,255\n",
                         {level, level, level});
        },
        40);
}

}  // namespace

TEST_CASE("without anything in the way, all lights add up (CR §3.1)", "[part trace]") {
    CHECK(shows(red_right + white_wall, {102, 0, 0}));
    CHECK(shows(red_right + green_left + white_wall, {102, 102, 0}));
}

TEST_CASE("a light with a shape in the way gives nothing (CR §3.2)") {
    CHECK(shows(red_right + white_wall + ball_on_the_right, {0, 0, 0}));
    CHECK(shows(green_left + ball_on_the_left + white_wall, {0, 0, 0}));
    // Of any size: a thousandth, and a thousand times.
    CHECK(shows("L 0.003,0,0 0.5 255,0,0\npl 0,0,-0.004 0,0,1 255,255,255\n", {102, 0, 0}));
    CHECK(
        shows("L 0.003,0,0 0.5 255,0,0\npl 0,0,-0.004 0,0,1 255,255,255\n"
              "sp 0.0015,0,-0.002 0.0004 9,9,9\n",
              {0, 0, 0}));
    CHECK(shows("L 3000,0,0 0.5 255,0,0\npl 0,0,-4000 0,0,1 255,255,255\n", {102, 0, 0}));
    CHECK(
        shows("L 3000,0,0 0.5 255,0,0\npl 0,0,-4000 0,0,1 255,255,255\n"
              "sp 1500,0,-2000 400 9,9,9\n",
              {0, 0, 0}));
    // Close to the light, and close to the wall.
    CHECK(shows(red_right + white_wall + "sp 2.985,0,-0.02 0.01 9,9,9\n", {0, 0, 0}));
    CHECK(shows(red_right + white_wall + "sp 0.015,0,-3.98 0.01 9,9,9\n", {0, 0, 0}));
    CHECK(shadows_at_both_ends());
}

TEST_CASE("a light that is blocked takes no other light away (CR §3.2)") {
    for (const std::string& lights : {red_right + green_left, green_left + red_right}) {
        CHECK(shows(lights + white_wall + ball_on_the_right, {0, 102, 0}));
        CHECK(shows(lights + white_wall + ball_on_the_left, {102, 0, 0}));
        CHECK(shows(lights + white_wall + ball_on_the_right + ball_on_the_left, {0, 0, 0}));
    }
    CHECK(random_lights_are_blocked(""));
}

TEST_CASE("a dim light is blocked as a bright one is (CR §3.2)") {
    for (const std::string light : {"L 3,0,0 0.05 255,0,0\n", "L 3,0,0 0.5 25,0,0\n"}) {
        CHECK(shows(light + white_wall, {10, 0, 0}));
        CHECK(shows(light + white_wall + ball_on_the_right, {0, 0, 0}));
    }
    std::string many;
    for (int i = 0; i < 1100; ++i) many += "L 3,0,0 0.0004 255,0,0\n";
    CHECK(shows(many + white_wall + ball_on_the_right, {0, 0, 0}));
}

TEST_CASE("ambient light reaches a shadow, and counts once (CR §3.2)") {
    const std::string ambient = "A 0.2 255,255,255\n";
    CHECK(shows(ambient + red_right + white_wall + ball_on_the_right, {51, 51, 51}));
    CHECK(shows(ambient + red_right + green_left + white_wall + ball_on_the_right, {51, 153, 51}));
    CHECK(term_has_shadows());
}

TEST_CASE("every kind of shape casts a shadow (CR §3.2)") {
    CHECK(every_kind_casts_a_shadow(""));
}

TEST_CASE(
    "a shape behind the light, behind the point or aside casts no shadow (CR §3.2, maxDist)") {
    for (const std::string ball :
         {"sp 4.5,0,2 0.4 9,9,9\n", "sp 9,0,8 0.4 9,9,9\n", "sp -1.5,0,-6 0.4 9,9,9\n",
          "sp -9,0,-16 0.4 9,9,9\n", "sp 1.5,1,-2 0.4 9,9,9\n", "sp 3.3,0,0.4 0.4 9,9,9\n",
          "sp 1.5,0,0 0.2 9,9,9\n", "sp 1.5,0,-3.9 0.2 9,9,9\n"})
        CHECK(shows(red_right + white_wall + ball, {102, 0, 0}));
}

TEST_CASE("a shape of any color and material casts a shadow, on itself too (CR §3.2)") {
    for (const std::string material : {"0,0,0", "255,255,255", "255,255,255 mirror:1"})
        CHECK(shows(red_right + white_wall + "sp 1.5,0,-2 0.2 " + material + "\n", {0, 0, 0}));
    // In a tube around the eye, of radius 4, with the light outside of it, or inside.
    const std::string tube = "cy 0,0,0 0,1,0 8 20 255,255,255\n";
    CHECK(shows("L 0,0,9 0.4 255,255,255\n" + tube, {0, 0, 0}));
    CHECK(shows("L 0,0,3 0.4 255,255,255\n" + tube, {102, 102, 102}));
}

TEST_CASE("each ray of a picture has its own shadows (CR §3.2)") {
    CHECK(for_all(
        [](Random& random) {
            const Rgb ambient = draw_color(random);
            const std::string light_in_a_ball = "L 0,0,9 1 255,255,255\nsp 0,0,9 2 9,9,9\n";
            return shows_in_every_pixel(
                "A 1 " + scene_color(ambient) + "\n" + white_wall + light_in_a_ball, ambient);
        },
        2));
}

TEST_CASE("two shapes in one light's way take away no more than one (CR §3.2)") {
    const std::string second = "sp 2.25,0,-1 0.2 9,9,9\n";
    CHECK(shows(red_right + green_left + white_wall + ball_on_the_right + second, {0, 102, 0}));
}

TEST_CASE("there is no highlight in a shadow (CR §3.2)") {
    // The eye is at 0.8 of the direction of reflection.
    const std::string shining = "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:1\n";
    const std::string light = "L 3,0,0 0.5 255,255,255\n";
    CHECK(shows(light + shining, {51, 51, 153}));
    CHECK(shows(light + shining + ball_on_the_right, {0, 0, 0}));
}

TEST_CASE("the surface that is seen casts no shadow on itself (CR §3.2)") {
    CHECK(shows("L 0,0,0 0.4 255,255,255\nsp 0,0,-5 2 255,255,255\n", {102, 102, 102}));
    CHECK(shows("L 0,0,0 0.4 255,255,255\nsp 0,0,0 8 255,255,255\n", {102, 102, 102}));
    CHECK(slanted_walls_are_lit());
}

TEST_CASE("a lamp that lies in a ceiling is not shadowed by it (CR §2.4, §3.2)") {
    CHECK(ceilings_leave_their_lamp());
}

TEST_CASE("the terms of all lights add up, from any eye (CR §3.1)") {
    CHECK(terms_add_up());
    CHECK(every_kind_is_lit_from_either_side(10));
}

TEST_CASE("the option --term selects a term (docs/step09_phong.md)") {
    CHECK(term_is_selected());
}

TEST_CASE("the picture of the stage, by this trace (CR §3.2)") {
    CHECK(picture_matches("step10_shadows"));
}
TEST_CASE("without a hit the pixel is black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shade_normal_shows_the_normal(10));
}
