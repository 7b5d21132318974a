// The question of a suite's report that `explain` repeats.
#include "common/course/exercise/failing_question.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

namespace {

std::optional<FailingQuestion> question(const std::string& failure) {
    return failing_question(
        {{.name = "right", .passed = true, .failure = "f(1)"},
         {.name = "exception", .failure = "f(1) == 2\n  got:      an exception"},
         {.name = "wrong", .failure = failure}});
}

}  // namespace

TEST_CASE("a call is repeated as it was reported, on one line") {
    const auto asked = question(
        "intersect(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}},\n          "
        "Sphere{.center = {0, 0, 0}, .radius = 1})\n  got:      no hit\n  expected: a hit at t = "
        "4");
    REQUIRE(asked);
    CHECK(asked->case_name == "wrong");
    CHECK(
        asked->call ==
        "intersect(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, Sphere{.center = {0, 0, 0}, "
        ".radius = 1})");
    CHECK(asked->scene.empty());
    CHECK_FALSE(question("the normal is no unit vector\n  got:      2"));
}

TEST_CASE("the case that check has shown comes before the first that fails") {
    const std::vector<CaseResult> results = {{.name = "first", .failure = "f(1)\n  got:      2"},
                                             {.name = "shown", .failure = "f(2)\n  got:      3"}};
    CHECK(failing_question(results, "shown")->call == "f(2)");
    CHECK(failing_question(results, "gone")->call == "f(1)");
    CHECK(failing_question(results)->call == "f(1)");
}

TEST_CASE("a scene is repeated with its options and its pixel") {
    const auto one = question(
        "the color of the only pixel, of 255\n  scene:    save it to render it, with --term "
        "specular"
        "\n              R 1 1\n              C 0,0,0 0,0,-1 60\n  got:      1\n  expected: 2");
    REQUIRE(one);
    CHECK(one->scene == "R 1 1\nC 0,0,0 0,0,-1 60\n");
    CHECK(one->pixel == "0,0");
    CHECK(one->options == Command{"--term", "specular"});
    CHECK(one->call.empty());
    const auto six = question(
        "the color of the pixel 1,2 of 3 x 2 pixels, of 255\n  scene:    save it to render it, "
        "with R "
        "3 2\n              R 1 1\n              C 0,0,0 0,0,-1 60\n  got:      1");
    REQUIRE(six);
    CHECK(six->scene == "R 3 2\nC 0,0,0 0,0,-1 60\n");
    CHECK(six->pixel == "1,2");
    CHECK(six->options.empty());
}
