// Stage 14, `trace`: tori beside the shapes of earlier stages.
#include "tests/suites/lights.hpp"
#include "tests/suites/mirrors.hpp"

#include "common/scene/scene.hpp"

using namespace rt;

TEST_CASE("every kind of shape so far is seen (geometry)", "[part trace]") {
    REQUIRE(all_kinds.size() == list_count);  // tests/suites/kinds.hpp has a line of each
    for (const Kind& kind : kinds_until(14))
        CHECK(shows("A 1 255,255,255\n" + kind.line(5, "0,255,0"), {0, 255, 0}));
}

TEST_CASE("the option --shade normal shows the normal (geometry)") {
    CHECK(shade_normal_shows_the_normal(14));
}

TEST_CASE("every kind of shape is a mirror (CR §5.1)") {
    CHECK(every_kind_is_a_mirror(14));
}

TEST_CASE("a torus casts a shadow, but not through its hole (CR §3.2)") {
    const std::string scene = "L 3,0,0 0.5 255,0,0\npl 0,0,-4 0,0,1 255,255,255\n";
    CHECK(shows(scene + "torus 1.5,0,-2 0.6,0,0.8 1 0.4 9,9,9\n", {102, 0, 0}));
    CHECK(shows(scene + "torus 1.5,0.5,-2 0.6,0,0.8 1 0.4 9,9,9\n", {0, 0, 0}));
}
