// Stage 3, `trace`: the closest of several spheres, against M1 ("plusieurs objets") and CR §2.1.
#include "tests/kit/picture.hpp"
#include "tests/suites/kinds.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

constexpr Rgb black = {0, 0, 0};
constexpr Rgb red = {255, 0, 0};
constexpr Rgb green = {0, 255, 0};

/// The scene with these lines shows the color, in each of their orders.
Verdict show_in_any_order(std::array<std::string, 3> lines, Rgb expected) {
    std::sort(lines.begin(), lines.end());
    Verdict all;
    do {
        keep_first(all, shows(lines[0] + lines[1] + lines[2], expected));
    } while (std::next_permutation(lines.begin(), lines.end()));
    return all;
}

}  // namespace

TEST_CASE("a ray that misses all spheres gives black (CR §2.1)", "[part trace]") {
    CHECK(shows("", black));
    CHECK(shows("sp 3,0,-5 2 255,0,0\n", black));
    CHECK(shows("sp 3,0,-5 2 255,0,0\nsp 0,-4,-9 3 0,255,0\n", black));
}

TEST_CASE("a ray that misses all spheres gives the color of the sky in its direction") {
    const std::string sky = "sky 0,0,255 255,0,0\n";
    CHECK(shows(sky, {128, 0, 128}));                             // level: half of each
    CHECK(shows(sky + "C 0,0,0 0,1,0 60\n", {255, 0, 0}));        // straight up
    CHECK(shows(sky + "C 0,0,0 0,-1,0 60\n", {0, 0, 255}));       // straight down
    CHECK(shows(sky + "C 0,0,0 0,0.6,-0.8 60\n", {204, 0, 51}));  // its height is 0.6: 80 % of it
    CHECK(shows(sky + "C 0,0,0 0,-0.6,-0.8 60\n", {51, 0, 204}));
    CHECK(shows(sky + "sp 3,0,-5 2 0,255,0\n", {128, 0, 128}));  // beside a sphere
}

TEST_CASE("a sphere that is alone is seen in its color (M1)") {
    CHECK(shows("sp 0,0,-5 2 255,0,0\n", red));
    CHECK(shows("sp 0,0,-50 2 40,80,160\n", {40, 80, 160}));
    CHECK(shows("sky 0,0,255 255,0,0\nsp 0,0,-5 2 0,255,0\n", green));
    // Far away, and near: CR begins at 0.001.
    CHECK(shows("sp 0,0,-300000000 200000000 255,0,0\n", red));
    CHECK(shows("sp 0,0,-300000000000000000 200000000000000000 255,0,0\n", red));
    CHECK(shows("sp 0,0,-0.006 0.002 255,0,0\n", red));
    CHECK(shows("sp 0,0,-0.0006 0.0002 255,0,0\n", red));
    CHECK(shows("sp 0,0,-0.0000006 0.0000002 255,0,0\n", red));
    CHECK(all_are_seen_from_the_other_side(3));
}

TEST_CASE("a sphere is seen beside others that the ray misses (CR §2.1)") {
    CHECK(show_in_any_order(
        {"sp 0,0,-5 2 255,0,0\n", "sp 3,0,-5 2 0,255,0\n", "sp 0,3,-4 2 0,0,255\n"}, red));
}

TEST_CASE(
    "the closest of several spheres is seen, in any order of the file (M1, \"plusieurs objets\")") {
    CHECK(show_in_any_order(
        {"sp 0,0,-5 2 255,0,0\n", "sp 0,0,-10 2 0,255,0\n", "sp 0,0,-20 2 0,0,255\n"}, red));
    // Nearer by its surface, not by its center.
    CHECK(show_in_any_order(
        {"sp 0,0,-10 16 255,0,0\n", "sp 0,0,-6 2 0,255,0\n", "sp 0,0,-30 4 0,0,255\n"}, red));
    // Nearer by its center's depth, not by its center's distance; lit at a cosine of 0.338.
    CHECK(show_in_any_order(
        {"sp 8,0,-9 17 255,0,0\n", "sp 0,0,-10 2 0,255,0\n", "sp 0,0,-30 4 0,0,255\n"},
        {86, 0, 0}));
    // Less than one unit of t lies between them, or before them.
    CHECK(show_in_any_order(
        {"sp 0,0,-5.25 2 255,0,0\n", "sp 0,0,-5.5 2 0,255,0\n", "sp 0,0,-5.75 2 0,0,255\n"}, red));
    CHECK(show_in_any_order(
        {"sp 0,0,-0.02 0.02 255,0,0\n", "sp 0,0,-0.2 0.2 0,255,0\n", "sp 0,0,-2 2 0,0,255\n"},
        red));
    CHECK(closest_of_random_shapes_is_seen(3, "", true));
    CHECK(closest_of_a_long_list_is_seen(3, "", true));
    CHECK(almost_equal_t_differ(""));
    CHECK(colors_do_not_depend_on_order(3, ""));
}

TEST_CASE("spheres behind the eye, alone and with one in front of it (PHY)") {
    CHECK(shows("sp 0,0,5 2 255,0,0\n", black));
    CHECK(show_in_any_order(
        {"sp 0,0,5 2 255,0,0\n", "sp 0,0,2 1 0,0,255\n", "sp 0,0,-9 2 0,255,0\n"}, green));
}

TEST_CASE(
    "the eye inside a sphere: its far side, and spheres nearer and farther than that (CR §2.1)") {
    CHECK(shows("sp 0,0,0 20 0,255,0\n", green));
    CHECK(show_in_any_order(
        {"sp 0,0,0 20 0,255,0\n", "sp 0,0,-5 2 255,0,0\n", "sp 0,0,-30 2 0,0,255\n"}, red));
    CHECK(show_in_any_order(
        {"sp 0,0,0 20 0,255,0\n", "sp 0,0,-15 2 255,0,0\n", "sp 0,0,0 60 0,0,255\n"}, green));
}

TEST_CASE("the torch lights the closest sphere, at the point that is seen (M1)") {
    // The ray hits it at 0,0,-6, where its normal is 0,-0.6,0.8.
    const std::string slanted = "sp 0,3,-10 10 255,255,255\n";
    CHECK(shows_exactly(slanted, Color(Real(0.8))));
    CHECK(shows_exactly("sp 0,3,-10 10 99,99,99\n", Color(Real(0.8) * 99 / 255)));  // 79.2 of 255
    CHECK(shows("sp 0,3,-10 10 255,100,0\n", {204, 80, 0}));
    CHECK(shows("C 1,2,3 0,0,-1 60\nsp 1,5,-7 10 255,255,255\n", {204, 204, 204}));
    CHECK(show_in_any_order({slanted, "sp 0,0,-20 2 255,0,0\n", "sp 0,0,-30 2 255,0,0\n"},
                            {204, 204, 204}));
    CHECK(show_in_any_order({slanted, "sp 0,0,-3 2 255,0,0\n", "sp 0,0,-30 2 0,0,255\n"}, red));
    // From its center, every ray hits a sphere at a right angle; the rays have several lengths.
    CHECK(shows_in_every_pixel("sp 0,0,0 8 120,80,40\n", {120, 80, 40}));
}

TEST_CASE("with --shade normal, trace shows the normal of the closest sphere (M1)") {
    const RenderSettings normals{.shading = Shading::normal};
    CHECK(shows("sp 0,3,-10 10 255,255,255\n", {0, 153, 204}, normals));
    CHECK(shows("sp 0,3,-10 10 255,0,0\nsp 0,0,-20 2 255,0,0\n", {0, 153, 204}, normals));
    CHECK(shows("sp 3,0,-5 2 255,0,0\n", black, normals));
    CHECK(shade_normal_shows_the_normal(3));
}

TEST_CASE("the picture of the stage, by this trace (HAI; CR §2.2)") {
    CHECK(picture_matches("step03_sphere"));
}
