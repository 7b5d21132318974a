// The comparison of two explanations of a pixel, as `explain` and `view` show it.
#include "common/course/exercise/log_diff.hpp"

#include "tests/kit/catch.hpp"

#include <algorithm>

using namespace rt;

namespace {

bool differ(const std::string& mine, const std::string& reference) {
    return !compare_logs(mine, reference).first.empty();
}

}  // namespace

TEST_CASE("numbers are compared, not their texts") {
    CHECK_FALSE(differ("The basis\n  X = (1, -0, 0)\n", "The basis\n  X = (1, 0, 0)\n"));
    CHECK_FALSE(differ("The ray\n  t = 4.000000000000001\n", "The ray\n  t = 4\n"));
    CHECK_FALSE(differ("  t = 1e-17\n", "  t = 0\n"));
    CHECK(differ("The ray\n  t = 4.001\n", "The ray\n  t = 4\n"));
    CHECK(differ("The ray\n  t = nan\n", "The ray\n  t = 4\n"));
    CHECK_FALSE(differ("The ray\n  t = nan\n", "The ray\n  t = nan\n"));
}

TEST_CASE("a scene of millimeters has differences of micrometers") {
    CHECK(differ("The ray\n  t = 0.004001\n", "The ray\n  t = 0.004\n"));
    CHECK_FALSE(differ("The ray\n  t = 0.004000000000000001\n", "The ray\n  t = 0.004\n"));
}

TEST_CASE("a shadow ray may end a little before the light, and not far before it") {
    const auto end = [](const char* t) {
        return "The light\n  the shadow ray's interval = (0, " + std::string(t) + ")\n";
    };
    CHECK_FALSE(differ(end("0.9999"), end("0.9999999999999881")));
    CHECK(differ(end("0.9"), end("0.9999999999999881")));
    CHECK(differ(end("inf"), end("0.9999999999999881")));
}

TEST_CASE("lines without a name are compared by their numbers too") {
    CHECK_FALSE(differ("S\n  missed at (0.30000000000000004, -0)\n", "S\n  missed at (0.3, 0)\n"));
    CHECK(compare_logs("S\n  missed at 3\n", "S\n  missed at 4\n").rows.size() == 2);
}

TEST_CASE("a function that is not written yet is reported once, and is no difference") {
    const std::string message =
        "steps/step04_plane/student/plane.cpp:7: intersect is not written yet";
    const LogDiff diff =
        compare_logs(message + "\nThe ray\n  t = 4\n" + message + "\n", "The ray\n  t = 4\n");
    CHECK(diff.first.empty());
    CHECK(diff.rows.size() == 2);
    REQUIRE(diff.unwritten.size() == 1);
    CHECK(diff.unwritten[0] == message);
    CHECK(text(diff) == message + "\nNothing differs.\n");
}

TEST_CASE("a trace with a loop of its own logs no shapes: only its color can differ") {
    const std::string start = "The ray\n  t = 4\n";
    const std::string shapes =
        "Sphere{.radius = 1}\n  A = 1\n  → hit\nThe closest hit\n  n = (0, 0, 1)\n";
    const auto pixel = [](const char* color) {
        return "The pixel\n  color = " + std::string(color) + "\n";
    };
    const LogDiff same = compare_logs(start + pixel("1"), start + shapes + pixel("1"));
    CHECK(same.has_own_loop);
    CHECK(same.first.empty());
    const LogDiff other = compare_logs(start + pixel("0"), start + shapes + pixel("1"));
    CHECK(other.first == "color, of The pixel");
    CHECK(text(other).starts_with("Your trace tests shapes in a loop of its own"));
    // Nothing to hit: both log nothing.
    CHECK_FALSE(compare_logs(start + pixel("0"), start + pixel("1")).has_own_loop);
    CHECK_FALSE(compare_logs(start + shapes, start + shapes).has_own_loop);
}

TEST_CASE("the first difference comes first with its section, and equal sections are left out") {
    const LogDiff diff = compare_logs("A\n  t = 1\nB\n  t = 2\n  → hit\nC\n  k = 1\n",
                                      "A\n  t = 1\nB\n  t = 3\nC\n");
    CHECK(text(diff) ==
          "The first difference: t, of B\n"
          "          B\n"
          "mine        t = 2\n"
          "reference   t = 3\n"
          "mine        → hit\n"
          "          C\n"
          "mine        k = 1\n");
    // The section of the first difference is before one that only the student's log has.
    CHECK(text(compare_logs("A\n  t = 1\nB\n  t = 2\n", "B\n  t = 3\n"))
              .starts_with("The first difference: t, of B\n          B\n"));
    const std::string third = "S{.r = Real(0.3333333333333333)}\n";
    CHECK(text(compare_logs(third + "  t = 1\n", third + "  t = 2\n"))
              .starts_with("The first difference: t, of S{.r = Real(0.3333333)}\n"));
}

TEST_CASE("an explanation is short unless all of it is asked for") {
    std::string mine = "A\n";
    std::string reference = "A\n";
    for (int i = 0; i < 100; ++i) {
        mine += "  t" + std::string(std::size_t(i), 'x') + " = 1\n";
        reference += "  t" + std::string(std::size_t(i), 'x') + " = 2\n";
    }
    const LogDiff diff = compare_logs(mine, reference);
    const std::string few = text(diff, "./course explain 3 --all");
    CHECK(std::count(few.begin(), few.end(), '\n') == 25);
    CHECK(few.ends_with("(178 more lines: ./course explain 3 --all)\n"));
    const std::string all = text(diff);
    CHECK(std::count(all.begin(), all.end(), '\n') == 202);
}

TEST_CASE(
    "the calls of a student's own loop are compared by their answers, not by their intervals") {
    const std::string far = "Sphere{.radius = 2}\n  A = 1\n";
    const std::string near = "Sphere{.radius = 1}\n  A = 1\n  → hit at t = 4\n";
    const std::string whole = far + "  → hit at t = 9\n";
    const std::string shortened =
        far +
        "  interval = (0, 4)\n  → not nearer: a hit at t = 9, behind the end of the interval\n";
    const std::string closest = "The closest hit\n  n = (0, 0, 1)\n";
    const auto compared = [&](const std::string& mine) {
        return compare_logs(mine, near + shortened + closest, Writer::own_loop).first;
    };
    CHECK(compared(near + whole).empty());
    CHECK(compared(near + shortened).empty());
    CHECK(compared(near + far + "  → hit at t = 8\n") == "the result, of Sphere{.radius = 2}");
    // With the same interval, a hit behind its end is one too many.
    CHECK(compared(near + far + "  interval = (0, 4)\n  → hit at t = 9\n") ==
          "the result, of Sphere{.radius = 2}");
    // The loop keeps another hit than the closest.
    const std::string shown = text(
        compare_logs(near + whole + "The pixel\n  color = 0.123456789012\n",
                     near + shortened + closest + "The pixel\n  color = 1\n", Writer::own_loop));
    CHECK(shown.find("    t = 4: Sphere{.radius = 1}\n    t = 9: Sphere{.radius = 2}\n") !=
          std::string::npos);
    CHECK(shown.find("mine        color = 0.1234568\n") != std::string::npos);
    // A shape that the loop does not test comes before the color that it causes.
    CHECK(compare_logs(near + "The pixel\n  color = 0\n",
                       near + shortened + closest + "The pixel\n  color = 1\n", Writer::own_loop)
              .first == "Sphere{.radius = 2}, which your loop does not test");
}

TEST_CASE("a section that only one explanation has is the first difference only if it is all") {
    const std::string light = "The light at (1, 2, 3)\n  N = (0, 1, 0)\n";
    const auto pixel = [](const char* color) {
        return "The pixel\n  color = " + std::string(color) + "\n";
    };
    CHECK(compare_logs(pixel("0"), light + pixel("1")).first == "color, of The pixel");
    CHECK(compare_logs(light + pixel("0"), pixel("1")).first == "color, of The pixel");
    CHECK(compare_logs(pixel("1"), light + pixel("1")).first ==
          "The light at (1, 2, 3), which only the reference's explanation has");
    CHECK(compare_logs("The light at (1, 2, 4)\n  N = (0, 1, 0)\n", light).first ==
          "The light at (1, 2, 4)");
}
