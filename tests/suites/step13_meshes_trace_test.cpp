// Stage 13, `trace`: boxes and meshes beside the other shapes, against CR §4.2 and M1.
#include "tests/suites/lights.hpp"
#include "tests/suites/mirrors.hpp"

#include "common/scene/scene.hpp"

#include <array>

using namespace rt;

namespace {

const std::string bright = "A 1 255,255,255\n";
const std::string wall = "mesh ../tests/suites/step13_meshes/wall.off ";

/// A box, and a mesh, halfway between 0,0,-4 and the light at 3,0,0.
const std::array<std::string, 2> in_the_way = {
    "box 1.5,0,-2 0,0,1 0.2,0.2,0.2 9,9,9\n",
    wall + "1.5,0,-2 0.2 9,9,9 dir:0.6,0,0.8\n",
};

/// grid.off has 26 x 20 squares of side 1, row by row from the origin, each cut in two triangles:
/// below the diagonal, and above it.
constexpr int columns_of_grid = 26;
constexpr int triangles_of_grid = 2 * columns_of_grid * 20;

/// The grid is moved so that the middle of this triangle is at the point, x,0,z.
std::string grid_around(int triangle, double x, double z, const std::string& color) {
    constexpr double scale = 0.01;
    const bool above = triangle % 2 == 1;
    const double middle_x = triangle / 2 % columns_of_grid + (above ? 1.0 : 2.0) / 3;
    const double middle_y = triangle / 2 / columns_of_grid + (above ? 2.0 : 1.0) / 3;
    const auto text = [](double number) { return std::to_string(number); };
    return "mesh ../tests/suites/step13_meshes/grid.off " + text(x - scale * middle_x) + "," +
           text(-scale * middle_y) + "," + text(z) + " " + text(scale) + " " + color + "\n";
}

/// The triangle is seen, and in the middle of the way to a light it casts a shadow.
Verdict triangle_is_hit(int triangle) {
    Verdict all;
    keep_first(all, shows(bright + grid_around(triangle, 0, -4, "0,255,0"), {0, 255, 0}));
    keep_first(all, shows("L 3,0,0 0.5 255,0,0\npl 0,0,-4 0,0,1 255,255,255\n" +
                              grid_around(triangle, 1.5, -2, "9,9,9"),
                          {0, 0, 0}));
    return all;
}

}  // namespace

TEST_CASE("every kind of shape is seen (M1, \"plusieurs objets\")", "[part trace]") {
    REQUIRE(all_kinds.size() == list_count);  // tests/suites/kinds.hpp has a line of each
    for (const Kind& kind : kinds_until(13)) {
        CHECK(shows(bright + kind.line(5, "0,255,0"), {0, 255, 0}));
        CHECK(shows("L 0,0,0 1 255,255,255\n" + kind.other_side(5, "0,255,0"),
                    {0, std::uint8_t(255 * kind.torch + 0.5), 0}));
    }
}

TEST_CASE("without a hit the pixel is black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shade_normal_shows_the_normal(13));
}

TEST_CASE("each kind of shape hides what is farther away, in any order of the file (CR §2.1)") {
    CHECK(nearest_of_each_pair_is_seen(13, bright, false));
}

TEST_CASE("a mesh of any scale is as far away as its place says (HAI, the frame of an object)") {
    for (const std::string scale : {"0.01", "0.5", "2", "1000"}) {
        const std::string mesh = wall + "0.002,0.003,-4 " + scale + " 255,0,0\n";
        CHECK(shows(bright + mesh + "sp 0,0,-7 2 0,0,255\n", {255, 0, 0}));
        CHECK(shows(bright + mesh + "sp 0,0,-3 0.5 0,0,255\n", {0, 0, 255}));
        CHECK(shows(bright + "box 0,0,-3 0,0,1 0.5,0.5,0.5 0,255,0\n" + mesh, {0, 255, 0}));
    }
}

TEST_CASE("boxes and meshes cast shadows (CR §3.2)") {
    const std::string scene =
        "L 3,0,0 0.5 255,0,0\nL -3,0,0 0.5 0,255,0\npl 0,0,-4 0,0,1 255,255,255\n";
    CHECK(shows(scene, {102, 102, 0}));
    for (std::size_t i = 0; i < in_the_way.size(); ++i) {
        CHECK(shows(scene + in_the_way[i], {0, 102, 0}));
        CHECK(blocks_at_any_place(scene, all_kinds[6 + i], in_the_way[i], {0, 102, 0}));
    }
    CHECK(shows(scene + "sp 1.5,0,-2 0.2 9,9,9\n", {0, 102, 0}));  // and so do earlier shapes
}

TEST_CASE("a mesh of any scale casts a shadow up to the light (CR §3.2, HAI)") {
    const std::string scene =
        "L 3,0,0 0.5 255,0,0\nL -3,0,0 0.5 0,255,0\npl 0,0,-4 0,0,1 255,255,255\n";
    for (const std::string scale : {"0.01", "0.2", "1", "10"}) {
        const std::string option = " " + scale + " 9,9,9 dir:0.6,0,0.8\n";
        // At nine tenths of its way, and at eleven.
        CHECK(shows(scene + wall + "2.7,0,-0.4" + option, {0, 102, 0}));
        CHECK(shows(scene + wall + "3.3,0,0.4" + option, {102, 102, 0}));
    }
}

TEST_CASE("each triangle of a large mesh is seen, and casts a shadow (CR §4.2)") {
    CHECK(for_all([](Random& random) { return triangle_is_hit(random.below(triangles_of_grid)); },
                  30));
    for (const int triangle : {0, 1, triangles_of_grid - 2, triangles_of_grid - 1})
        CHECK(triangle_is_hit(triangle));
}

TEST_CASE("boxes and meshes hide an area light (CR §3.3)") {
    const std::string scene = "L 3,0,0 0.5 255,0,0 radius:0.05\npl 0,0,-4 0,0,1 255,255,255\n";
    CHECK(shows(scene, {102, 0, 0}));
    for (const std::string& shape : in_the_way) CHECK(shows(scene + shape, {0, 0, 0}));
}

TEST_CASE("boxes and meshes are seen in a mirror, and are mirrors (CR §5.1)") {
    const std::string mirror = "pl 0,0,-4 0,0,1 255,255,255 mirror:1\n";
    CHECK(shows(bright + mirror + "box 0,0,6 0,0,1 2,2,2 0,255,0\n", {0, 255, 0}));
    CHECK(shows(bright + mirror + wall + "0,0,6 1 0,255,0\n", {0, 255, 0}));
    const std::string behind = "pl 0,0,6 0,0,-1 255,0,0\n";
    CHECK(shows(bright + "box 0,0,-5 0,0,1 2,2,2 0,0,255 mirror:1\n" + behind, {255, 0, 0}));
    CHECK(shows(bright + wall + "0,0,-5 1 0,0,255 mirror:0.2\n" + behind, {51, 0, 204}));
    CHECK(every_kind_is_a_mirror(13));
    CHECK(mirrors_show_mirrors(13, in_the_way));
    CHECK(mirrors_show_mirrors(13));  // in which earlier shapes cast shadows
}

TEST_CASE("boxes and meshes cast the shadows that a mirror shows (CR §5.1)") {
    const std::string scene =
        "pl 0,0,-4 0,0,1 255,255,255 mirror:1\nL 3,0,2 0.5 255,255,255\n"
        "pl 0,0,6 0,0,-1 255,255,255\n";
    CHECK(shows(scene + "box 1.5,0,4 0,0,1 0.2,0.2,0.2 9,9,9\n", {0, 0, 0}));
    CHECK(shows(scene + wall + "1.5,0,4 0.2 9,9,9 dir:0.6,0,-0.8\n", {0, 0, 0}));
}

TEST_CASE("boxes and meshes are lit like other shapes (CR §3.1)") {
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    CHECK(shows(light + "box 0,0,-5 0,0,1 2,2,2 255,255,255\n", {102, 102, 102}));
    CHECK(shows(light + wall + "0,0,-5 1 255,255,255\n", {102, 102, 102}));
    CHECK(shows("A 0.2 255,255,255\n" + light + wall + "0,0,-5 1 255,255,255\n", {153, 153, 153}));
}

TEST_CASE("a mesh is lit by its interpolated normals (CR §4.1.2)") {
    // The ridge is at 0,0,-5: its normal is the mean of the two sides, which face the eye at 45°.
    const std::string roof_file = "mesh ../tests/suites/step13_meshes/roof.off";
    const std::string roof = roof_file + " 0,0,-5 1 255,255,255";
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    const RenderSettings normals{.shading = Shading::normal};
    CHECK(shows(light + roof + "\n", {102, 102, 102}));
    CHECK(shows(light + roof + " normals:flat\n", {72, 72, 72}));
    CHECK(shows(roof + "\n", {0, 0, 255}, normals));
    CHECK(shows(roof + " normals:flat\n", {180, 0, 180}, normals));
    // The same in a mirror.
    CHECK(shows(light + "pl 0,0,-4 0,0,1 255,255,255 mirror:1\n" + roof_file +
                    " 0,0,6 1 255,255,255 dir:0,0,-1\n",
                {102, 102, 102}));
}

TEST_CASE("mirrors are as in stage 12 (CR §5.1)") {
    CHECK(mirrors_show_all_terms());
    CHECK(mirrors_do_not_show_themselves());
    CHECK(mirrors_show_black_or_sky());
    CHECK(mirrors_show_what_is_close());
    CHECK(mirrors_show_soft_shadows());
    CHECK(reflections_end());
    CHECK(weak_reflections_are_black());
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
}

TEST_CASE("the option --term selects a term (docs/step09_phong.md)") {
    CHECK(term_is_selected());
}
