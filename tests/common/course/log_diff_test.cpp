// The comparison of two explanations of a pixel, as `explain` and `view` show it.
#include "common/course/exercise/log_text.hpp"

#include "tests/kit/catch.hpp"

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

TEST_CASE("equal sections are left out, and the first difference has a name") {
    CHECK(text(compare_logs("A\n  t = 1\nB\n  t = 2\n  → hit\nC\n  k = 1\n",
                            "A\n  t = 1\nB\n  t = 3\nC\n")) ==
          "          B\n"
          "mine        t = 2\n"
          "reference   t = 3\n"
          "mine        → hit\n"
          "          C\n"
          "mine        k = 1\n"
          "(equal sections left out: 1)\n"
          "\n"
          "The first difference: t, of B\n");
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
