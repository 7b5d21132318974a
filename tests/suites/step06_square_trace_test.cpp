// Stage 6, `trace`: squares beside the shapes of earlier stages, against M1 ("plusieurs objets")
// and CR §2.1.
#include "tests/kit/picture.hpp"
#include "tests/suites/kinds.hpp"

using namespace rt;

TEST_CASE("every kind of shape so far is seen (M1, \"plusieurs objets\")", "[part trace]") {
    for (const Kind& kind : kinds_until(6)) {
        const auto light = std::uint8_t(255 * kind.torch + 0.5);
        CHECK(shows(kind.line(5, "0,255,0"), {0, light, 0}));
        CHECK(shows(kind.other_side(5, "0,255,0"), {0, light, 0}));
    }
    CHECK(all_are_seen_from_the_other_side(6));
}

TEST_CASE("a ray that misses all shapes gives black, or the color of the sky (stage 3)") {
    CHECK(nothing_is_black_or_sky());
}

TEST_CASE("the option --shade normal shows the normal (M1)") {
    CHECK(shade_normal_shows_the_normal(6));
}

TEST_CASE("the closest of two kinds of shapes is seen, in any order of the file (CR §2.1)") {
    CHECK(nearest_of_each_pair_is_seen(6, "", true));
}

TEST_CASE("the picture of the stage, by this trace (HAI)") {
    CHECK(picture_matches("step06_square"));
}
