// Stage 9, `trace`: the lights of a scene, against CR §3.1.
//
// The ray hits the wall at 0,0,-4. A light at the origin lights that point with its whole
// brightness, since it is straight before it.
#include "tests/kit/picture.hpp"
#include "tests/suites/lights.hpp"

using namespace rt;

namespace {

const std::string white_wall = "pl 0,0,-4 0,0,1 255,255,255\n";

/// Up to five lights of random brightness and color, at the eye.
Verdict random_lights_add_up() {
    return for_all(
        [](Random& random) {
            std::string lights;
            Color sum(0);
            for (int count = 1 + random.below(5); count > 0; --count) {
                const int percent = 1 + random.below(19);
                const Rgb color = draw_color(random);
                lights +=
                    "L 0,0,0 " + std::to_string(percent * 0.01) + " " + scene_color(color) + "\n";
                sum += Real(percent * 0.01) * Color(color[0], color[1], color[2]) / Real(255);
            }
            const Rgb wall = draw_color(random);
            const std::string shape = "pl 0,0,-4 0,0,1 " + scene_color(wall) + "\n";
            return shows(random.coin() ? lights + shape : shape + lights, scaled(wall, sum));
        },
        40);
}

}  // namespace

TEST_CASE("the closest of two kinds of shapes is seen, in any order of the file (CR §2.1)",
          "[part trace]") {
    CHECK(nearest_of_each_pair_is_seen(9, "A 1 255,255,255\n", false));
}

TEST_CASE("a ray that misses all shapes gives black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("without a light a surface is black, and so is what no shape covers (CR §3.1)") {
    CHECK(shows(white_wall, {0, 0, 0}));
    CHECK(shows("A 1 255,255,255\nL 0,0,0 1 255,255,255\n", {0, 0, 0}));
}

TEST_CASE("a scene with ambient light only shows the color times its ratio (CR §3.1)") {
    CHECK(shows("A 0.2 255,255,255\n" + white_wall, {51, 51, 51}));
    CHECK(shows("A 0.2 255,255,255\npl 0,0,-4 0,0.6,0.8 255,255,255\n", {51, 51, 51}));
    CHECK(shows("A 0.4 255,0,255\npl 0,0,-4 0,0,1 255,255,0\n", {102, 0, 0}));
}

TEST_CASE("the light of two lights adds up (CR §3.1)") {
    const std::string red = "L 0,0,0 0.4 255,0,0\n";
    const std::string green = "L 0,0,0 0.2 0,255,0\n";
    CHECK(shows(red + white_wall, {102, 0, 0}));
    CHECK(shows(red + green + white_wall, {102, 51, 0}));
    CHECK(shows(green + red + white_wall, {102, 51, 0}));
    CHECK(shows(red + red + white_wall, {204, 0, 0}));
    std::string five;
    for (int i = 0; i < 5; ++i) five += "L 0,0,0 0.1 255,255,255\n";
    CHECK(shows(five + white_wall, {127, 127, 127}));
    std::string many;
    for (int i = 0; i < 1100; ++i) many += "L 0,0,0 0.0004 255,255,255\n";
    CHECK(shows(many + white_wall, {112, 112, 112}));
    CHECK(random_lights_add_up());
    CHECK(terms_add_up());
}

TEST_CASE("ambient light in scenes with several lights (CR §3.1)") {
    const std::string ambient = "A 0.2 255,255,255\n";
    const std::string light = "L 0,0,0 0.2 255,255,255\n";
    CHECK(shows(ambient + light + white_wall, {102, 102, 102}));
    CHECK(shows(ambient + light + light + white_wall, {153, 153, 153}));
    CHECK(shows(ambient + light + light + light + white_wall, {204, 204, 204}));
}

TEST_CASE("a light behind the surface, alone and beside other lights (CR §3.1)") {
    const std::string front = "L 0,0,0 0.4 255,255,255\n";
    const std::string behind = "L 0,0,-9 1 255,255,255\n";
    CHECK(shows(behind + white_wall, {0, 0, 0}));
    CHECK(shows(behind + front + white_wall, {102, 102, 102}));
    CHECK(shows(front + behind + white_wall, {102, 102, 102}));
}

TEST_CASE("each light adds its own highlight (CR §3.1)") {
    const std::string shining = "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:10\n";
    CHECK(shows("L 0,0,0 0.4 255,255,255\n" + shining, {51, 51, 153}));
    CHECK(shows("L 0,0,0 0.4 255,0,0\nL 0,0,0 0.2 0,255,0\n" + shining, {51, 26, 0}));
    // The light is reflected away from the eye, along 0,0.96,-0.28.
    CHECK(shows("L 0,-2.688,0.216 1 255,255,255\npl 0,0,-4 0,0.6,0.8 0,0,0 spec:1 shin:1\n",
                {0, 0, 0}));
}

TEST_CASE("the surface is lit on the side of the eye (CR §3.1)") {
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    CHECK(shows(light + "pl 0,0,-4 0,0,-1 255,255,255\n", {102, 102, 102}));
    CHECK(shows(light + "sp 0,0,0 8 255,255,255\n", {102, 102, 102}));
    CHECK(shows("L 0,0,-9 1 255,255,255\nsp 0,0,0 8 255,255,255\n", {0, 0, 0}));
    CHECK(every_kind_is_lit_from_either_side(9));
}

TEST_CASE("the option --term selects a term (docs/step09_phong.md)") {
    CHECK(term_is_selected());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shows("pl 0,0,-4 0,0.6,0.8 255,0,0\n", {0, 153, 204}, {.shading = Shading::normal}));
}

TEST_CASE("the picture of the stage, by this trace (CR §3.1)") {
    CHECK(picture_matches("step09_phong"));
}
