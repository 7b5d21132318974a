// What `./course check` shows first of what fails, and how.
#include "common/course/exercise/failure_text.hpp"

#include "common/course/exercise/failing_question.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/course/exercise/judgment.hpp"
#include "common/course/exercise/telling_case.hpp"
#include "common/system/files.hpp"
#include "common/system/wrap.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>
#include <random>

using namespace rt;

namespace {

CaseResult failed(const std::string& name, const std::string& part, const std::string& text = "") {
    return {.name = name, .part = part, .failure = text};
}

/// Two functions: `near` of two cases, and `far`, which a case calls together with `near`.
const KnownCases of_two{.mistakes = {{"all", {"plain", "extreme", "both"}, "plain"},
                                     {"small", {"extreme"}, "extreme"},
                                     {"away", {"far away"}, "far away"}},
                        .calls = {{"plain", {"near"}},
                                  {"extreme", {"near"}},
                                  {"far away", {"far"}},
                                  {"both", {"near", "far"}}}};

}  // namespace

TEST_CASE("the case that the author names for the likest mistake comes first") {
    const CaseResult plain = failed("plain", "near");
    const CaseResult extreme = failed("extreme", "near");
    CHECK(most_telling({extreme, plain}, "near", {}, of_two) == 1);
    CHECK(most_telling({plain, extreme}, "near", {"small"}, of_two) == 1);
    // If no mistake is known by these cases, the one that fewer mistakes fail comes first.
    KnownCases unnamed = of_two;
    for (KnownFailure& each : unnamed.mistakes) each.caught_by.clear();
    CHECK(most_telling({extreme, plain}, "near", {}, unnamed) == 1);
    // A random one of the same case's kind is later, and a whole picture last.
    const CaseResult random =
        failed("plain", "near", "f(1)\n  got: 1\n  random:   case 3 of 300\n");
    CHECK(most_telling({random, extreme}, "near", {}, of_two) == 1);
    CHECK(most_telling({failed("the picture of the stage", "near"), extreme}, "near", {}, {}) == 1);
    CHECK(most_telling({failed("far away", "far")}, "near", {}, of_two) == 1);
    CHECK(first_failing({CaseResult{.name = "plain", .part = "near", .passed = true}, extreme},
                        "near") == 1);
}

TEST_CASE("a part that fails because of another function is not the one to mend") {
    const std::vector<CaseResult> shared = {failed("both", "near"), failed("far away", "far")};
    CHECK(part_to_mend(shared, of_two) == "far");
    CHECK(part_to_mend({failed("both", "near"), failed("plain", "near")}, of_two) == "near");
    CHECK(part_to_mend({failed("both", "near")}, of_two) == "near");
    CHECK(part_to_mend({CaseResult{.name = "plain", .part = "near", .passed = true}}, of_two)
              .empty());
    CHECK(parts_that_use("near", {failed("plain", "near"), failed("both", "far")}, of_two) ==
          std::vector<std::string>{"far"});
    CHECK(parts_that_use("near", {failed("plain", "near"), failed("far away", "far")}, of_two)
              .empty());
}

TEST_CASE("every known mistake has a case of its author's, in a hand-out too") {
    const std::filesystem::path mistakes = std::filesystem::path(RAYSTEPS_ROOT) / mistakes_folder;
    const TemporaryFolder folder(std::filesystem::temp_directory_path());
    std::filesystem::copy(mistakes, folder.path() / "mistakes");
    for (const char* file : {"probes.txt", "trace.txt"}) {
        std::filesystem::create_directories(folder.path() / "mistakes/step03_sphere");
        std::filesystem::copy(mistakes / "step03_sphere" / file,
                              folder.path() / "mistakes/step03_sphere" / file);
    }
    const KnownCases whole = known_cases(mistakes, "step03_sphere");
    CHECK(whole.mistakes.size() > 20);
    for (const KnownFailure& each : whole.mistakes) {
        INFO(each.mistake);
        CHECK_FALSE(each.caught_by.empty());
    }
    std::filesystem::create_directories(in_handout(folder.path() / "mistakes"));
    for (const auto& catalogue : files_in(folder.path() / "mistakes", ".txt")) {
        write_text(in_handout(folder.path() / "mistakes") / catalogue.filename(),
                   authors_cases(read_text(catalogue)));
        std::filesystem::remove(catalogue);
    }
    const KnownCases handed = known_cases(folder.path() / "mistakes", "step03_sphere");
    REQUIRE(handed.mistakes.size() == whole.mistakes.size());
    for (std::size_t i = 0; i < handed.mistakes.size(); ++i)
        CHECK(handed.mistakes[i].caught_by == whole.mistakes[i].caught_by);
}

TEST_CASE("a call has no default fields, no casts, and the digits that matter") {
    CHECK(brief_code("f(ShadingPoint{.point = {0, 0, 1}, .error = 0, .material = Material{.color = "
                     "{1, 1, 1}, .specular = 0, .shininess = 32, .mirror = 0}}, Light{.position = "
                     "{0, Real(-0.5), 4}, .brightness = 1, .color = {1, 1, 1}, .radius = 0})") ==
          "f(ShadingPoint{.point = {0, 0, 1}}, Light{.position = {0, -0.5, 4}, .brightness = 1, "
          ".color = {1, 1, 1}})");
    CHECK(brief_code("Material{.color = {1, 1, 1}, .specular = Real(0.5), .shininess = 32}") ==
          "Material{.specular = 0.5}");
    CHECK(brief_code("Sphere{.center = {0, 0, Real(-0.0)}, .radius = 0}") ==
          "Sphere{.center = {0, 0, 0}, .radius = 0}");
    CHECK(brief_code("{Real(2.000000000001819), Real(-5.000000001), Real(1.0471975511965976)}") ==
          "{2, -5.000000001, 1.047198}");
    CHECK(brief_code("case 12345678 of erratum_2.5e") == "case 12345678 of erratum_2.5e");
}

TEST_CASE("answers have the digits that tell them apart; lines for later are left out") {
    const std::string failure =
        "f(Real(0.25))\n  got:      a hit at t = 2.1249999999999996\n  expected: no hit\n"
        "  paste:    CHECK(f(Real(0.25),\n              2));\n  random:   case 1 of 300\n";
    CHECK(failure_lines(failure, false) ==
          std::vector<std::string>{"f(0.25)", "  got:      a hit at t = 2.125",
                                   "  expected: no hit"});
    CHECK(failure_lines(failure, true).size() == 6);
    CHECK(failure_lines("f(x)\n  got:      (NaN, 0.3333333333333333)\n"
                        "  expected: (1, 0.333333333334)\n",
                        false) == std::vector<std::string>{"f(x)", "  got:      (NaN, 0.333333)",
                                                           "  expected: (1, 0.333333)"});
    CHECK(failure_lines("f(x)\n  got:      0.3333333333333333\n  expected: 0.333333333334\n",
                        false) == std::vector<std::string>{"f(x)", "  got:      0.333333333333",
                                                           "  expected: 0.333333333334"});
    CHECK(
        failure_lines("a color\n  scene:    save it\n              sp 0,0,-5.000000001 2\n", false)
            .back() == "              sp 0,0,-5.000000001 2");
    const std::string occluded =
        "f(x)\n  got:      Ray{}\n  which has a hit at t = 2.4427349276681122e-17 with Sphere{}\n";
    CHECK(failure_lines(occluded, false).back() ==
          "  which has a hit at t = 2.442735e-17 with Sphere{}");
    CHECK(length_of_call(failure) == 13);
}

TEST_CASE("a text of too many lines ends with a mark") {
    CHECK(fitted("1\n2\n3\n", 3, "…") == "1\n2\n3\n");
    CHECK(fitted("1\n2\n3\n4\n", 3, "…") == "1\n2\n…\n");
    CHECK(fitted("1\n2\n3\n", 0, "…") == "1\n…\n");
}

TEST_CASE("a vector and a value stay on the line of what they belong to") {
    CHECK(wrapped("f(A{.a = {1, 2, 3}, .b = 4})", 20) == "f(A{.a = {1, 2, 3},\n    .b = 4})");
    CHECK(wrapped("f(A{.abc = {1, 2, 3}})", 14) == "f(A{.abc = {1, 2, 3}})");
}

TEST_CASE("what the output says is unwritten is found, and other lines are the student's") {
    CHECK(unwritten_in("steps/a.cpp:22: intersect is not written yet\nhello\n"
                       "steps/b.cpp:3: trace is not written yet\n") ==
          std::vector<std::string>{"intersect", "trace"});
}

TEST_CASE("a crash leaves cases out, which count all the same") {
    Judged judged{.suite = {.cases = {{.name = "a", .passed = true}, {.name = "b"}},
                            .ended = "your code crashed.",
                            .output = "",
                            .not_reached = 44}};
    CHECK(Judgment(judged, std::nullopt).cases() == 46);
    CHECK(Judgment(judged, std::nullopt).passed() == 1);
    CHECK(cases_in_suite("cases 46\ncase a\npassed\n") == 46);
    CHECK(cases_in_suite("case a\npassed\n") == 0);
    CHECK(read_report("cases 46\ncase a\npassed\n").size() == 1);
}

TEST_CASE("samples in another order are noise, and a darker picture is none") {
    const Resolution size{.width = 32, .height = 32};
    std::mt19937 random(1);
    Image mine(size);
    Image reference(size);
    for (std::size_t i = 0; i < mine.pixels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            mine.pixels[i][k] = std::uint8_t(100 + random() % 33);
            reference.pixels[i][k] = std::uint8_t(100 + random() % 33);
        }
    CHECK(is_noise(mine, reference));
    CHECK_FALSE(is_noise(mine, mine));
    for (Rgb& pixel : mine.pixels)
        for (std::uint8_t& level : pixel) level = std::uint8_t(level - 6);
    CHECK_FALSE(is_noise(mine, reference));
}

// The question of a suite's report that `explain` repeats.

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

TEST_CASE("a magnified picture has a square for each pixel") {
    Image image({3, 2});
    for (int i = 0; i < 6; ++i) image.pixels[std::size_t(i)] = {std::uint8_t(40 * i), 7, 9};
    const Image large = magnified(image, 4);
    REQUIRE(large.resolution.width == 12);
    REQUIRE(large.resolution.height == 8);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 12; ++column)
            CHECK(large[{row, column}] == image[{row / 4, column / 4}]);
}

TEST_CASE("the center of a difference is in its largest cluster") {
    Image reference({8, 6});
    Image mine = reference;
    for (const Pixel pixel : {Pixel{0, 7}, {3, 2}, {3, 3}, {3, 4}, {4, 3}, {2, 3}})
        mine[pixel] = {200, 0, 0};
    const Comparison comparison = compare(mine, reference);
    CHECK(comparison.different == 6);
    REQUIRE(comparison.center);
    CHECK(comparison.center->row == 3);
    CHECK(comparison.center->column == 3);
}
