// Texts that `./course` prints: suggestions, long lines, errors of the linker.
#include "common/course/build/compiler_errors.hpp"

#include "common/course/build/project.hpp"
#include "common/course/build/suite_report.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/system/files.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/terminal.hpp"
#include "common/system/wrap.hpp"

#include "tests/kit/catch.hpp"

#include <regex>
#include <set>

using namespace rt;

TEST_CASE("a typo gets a suggestion, and another word none") {
    const std::vector<std::string> known = {"start", "check",    "watch",  "triangle",
                                            "plane", "cylinder", "phong",  "step05_triangle",
                                            "cone",  "shadows",  "sphere", "soft_shadows"};
    for (const auto& [typo, meant] :
         std::vector<std::pair<std::string, std::string>>{{"chek", "check"},
                                                          {"CHECK", "check"},
                                                          {"tringle", "triangle"},
                                                          {"Triangle", "triangle"},
                                                          {"trinagle", "triangle"},
                                                          {"cyl", "cylinder"},
                                                          {"sart", "start"},
                                                          {"shperes", "sphere"},
                                                          {"step5_triangle", "step05_triangle"}})
        CHECK(suggestion(typo, known) == " Did you mean " + meant + "?");
    for (const char* other : {"", "14", "x", "help", "my_scene.rt", "mirrors"})
        CHECK(suggestion(other, known).empty());
}

TEST_CASE("the time left is not guessed from the first edges") {
    CHECK(time_left(4.9, 50, 100).empty());
    CHECK(time_left(60, 4, 100).empty());
    CHECK(time_left(5, 5, 100) == ", 95 s left");
    CHECK(time_left(30, 75, 100) == ", 10 s left");
}

TEST_CASE("a long line is broken at spaces, not in texts, and stays C++") {
    CHECK(wrapped("short, and whole", 40) == "short, and whole");
    CHECK(wrapped("  CHECK(hits(first, second, third));", 20) ==
          "  CHECK(hits(first,\n      second,\n      third));");
    CHECK(wrapped("f(\"a, b, c, d\", e)", 12) == "f(\"a, b, c, d\",\n    e)");
    CHECK(wrapped("  three is not written yet", 20) == "  three is not\n      written yet");
    CHECK(wrapped("check N  tests it all", 16, 9) == "check N  tests\n         it all");
    CHECK(wrapped("without_a_comma_it_is_longer", 10) == "without_a_comma_it_is_longer");
    CHECK(wrapped("ééé, ééé, ééé", 13) == "ééé, ééé, ééé");
}

TEST_CASE("of a compiler's message the text is broken, and the code that it quotes is cut") {
    const std::string code =
        "   26 | Ray to_world(const Ray& ray)\n      |                     ~~~~\n";
    CHECK(
        wrapped_diagnostic("a.cpp:3:4: warning: unused parameter ‘ray’ [-Wunused]\n" + code, 21) ==
        "a.cpp:3:4: warning:\n    unused parameter\n    ‘ray’ [-Wunused]\n"
        "   26 | Ray to_world…\n      |             …\n");
    CHECK(wrapped_diagnostic(code, 40) == code);
    CHECK(wrapped_diagnostic(" | ééééé\n", 8) == " | ééééé\n");
    CHECK(wrapped_diagnostic(" | ééééé\n", 7) == " | ééé…\n");
}

TEST_CASE("a compiler's error has the note that belongs to it, of the project's files") {
    const std::string file = "steps/step03_sphere/student/sphere.cpp";
    const std::string error =
        file + ":3:10: error: 'cout' is not a member of 'std'\n    3 |     std::cout << 1;\n";
    const std::string note =
        file +
        ":1:1: note: did you forget to '#include <iostream>'?\n  +++ |+#include <iostream>\n";
    const std::string next =
        "/x/" + file + ":7:1: error: expected ';'\n/x/" + file + ":8:1: note: to match this '{'\n";
    CHECK(first_error("In file included from x.cpp:1:\n/x/" + error + "/x/" + note + next) ==
          error + note);
    CHECK(first_error("/x/" + error + next) == error);
    CHECK(first_error("/x/" + error + "/usr/include/glm/vec3.hpp:9:1: note: candidate\n" + next) ==
          error);
    CHECK(first_error("/x/" + error + "/x/common/math/vector.hpp:5:6: note: argument 1\n") ==
          error + "common/math/vector.hpp:5:6: note: argument 1\n");
}

TEST_CASE("a symbol that is defined twice is named with its files") {
    const std::string a =
        "steps/step03_sphere/CMakeFiles/step03_sphere_student_f32.dir/student/sphere.cpp.o";
    const std::string b =
        "steps/step07_cylinder/CMakeFiles/step07_cylinder_student_f32.dir/student/cylinder.cpp.o";
    const std::string both =
        " in steps/step07_cylinder/student/cylinder.cpp, steps/step03_sphere/student/sphere.cpp";
    const std::string cure =
        "\nPut helper functions into an anonymous namespace: namespace { … }\n";
    CHECK(first_error("mold: error: duplicate symbol: " + b + ": " + a + ": rt::solve(float)\n") ==
          "error: defined twice: rt::solve(float)" + both + cure);
    CHECK(first_error("/usr/bin/ld: " + b + ": in function `rt::solve(float)':\n" +
                      "cylinder.cpp:(.text+0x0): multiple definition of `rt::solve(float)'; " + a +
                      ":sphere.cpp:(.text+0x0): first defined here\n")
              .rfind("error: defined twice: rt::solve(float)", 0) == 0);
}

TEST_CASE("a main of the student's is named with any linker") {
    const std::string mine =
        "steps/step03_sphere/CMakeFiles/step03_sphere_student_f64.dir/student/sphere.cpp.o";
    const std::string twice =
        "error: defined twice: main in steps/step03_sphere/student/sphere.cpp\n"
        "The program has a main of its own: remove yours.\n";
    for (const std::string& message : {
             "mold: error: duplicate symbol: main.cpp.o: " + mine + ": main\n",
             "mold: error: duplicate symbol: /usr/lib/libCatch2Main.a(catch_with_main.cpp.o): " +
                 mine + ": main\n",
             "/usr/bin/ld.bfd: " + mine +
                 ": in function `main':\nsphere.cpp:(.text+0x0): multiple definition of `main'; "
                 "main.cpp.o:main.cpp:(.text+0x0): first defined here\n",
             "/usr/bin/ld.gold: error: " + mine +
                 ": multiple definition of 'main'\n/usr/bin/ld.gold: main.cpp.o: previous "
                 "definition here\n",
             "ld.lld: error: duplicate symbol: main\n>>> defined at main.cpp\n>>>            "
             "main.cpp.o:(main)\n>>> defined at sphere.cpp\n>>>            " +
                 mine + ":(.text+0x0)\n",
             "duplicate symbol '_main' in:\n    /x/main.cpp.o\n    /x/" + mine + "\n",
         })
        CHECK(first_error(message) == twice);
}

TEST_CASE(
    "a warning about an inlined function of a header is at its call, and before lesser ones") {
    const std::string mine = "steps/step03_sphere/student/sphere.cpp";
    const std::string unused = mine + ":4:9: warning: unused variable 'x' [-Wunused-variable]\n";
    const std::string note = mine +
                             ":6:16: note: 't2' was declared here\n    6 |     Real t1, t2;\n"
                             "      |              ^~\n";
    const std::string header =
        "In member function 'bool rt::Interval::contains(rt::Real) const',\n"
        "    inlined from 'std::optional<double> rt::intersect(Real)' at /x/" +
        mine +
        ":14:19:\n/x/common/geometry/ray.hpp:27:83: warning: 't2' may be used uninitialized "
        "[-Wmaybe-uninitialized]\n   27 |     return t > min;\n      |            ^~~~~~~\n";
    const std::string shown =
        mine + ":14:19: warning: 't2' may be used uninitialized [-Wmaybe-uninitialized]\n" + note;
    CHECK(first_warning("/x/" + unused) == unused);
    CHECK(first_warning("/x/" + unused + header + "/x/" + mine + ": In function 'f':\n/x/" + note +
                        header) == shown);
    CHECK(first_warning(header + header) == shown.substr(0, shown.find('\n') + 1));
    const auto as_error = [](std::string text) {
        return text.replace(text.find("warning: "), 9, "error: ");
    };
    CHECK(first_error(as_error(header) + "/x/" + note) == as_error(shown));
    CHECK(first_warning("/x/common/geometry/ray.hpp:27:83: warning: 't2' [-Wuninitialized]\n") ==
          "");
}

TEST_CASE("an assertion of the standard library is a sentence with its place") {
    const auto sentence = [](std::string output) {
        const std::string taken = take_assertion(output);
        CHECK(output == "mine\n");
        return taken;
    };
    CHECK(sentence(
              "mine\n/usr/include/c++/12/optional:477: constexpr _Tp& std::_Optional_base_impl<"
              "_Tp>::_M_get() [with _Tp = double]: Assertion 'this->_M_is_engaged()' failed.\n") ==
          "A std::optional without a value was read, by * or -> "
          "(/usr/include/c++/12/optional:477: Assertion 'this->_M_is_engaged()' failed.)");
    CHECK(sentence("/usr/include/c++/v1/array:231: libc++ Hardening assertion __n < _Size failed: "
                   "out-of-bounds access in std::array<T, N>\nmine\n")
              .starts_with("An index is out of range"));
    CHECK(
        sentence("step03_sphere_test_double: /x/sphere.cpp:12: Real rt::f(Real): Assertion `t > 0' "
                 "failed.\nmine\n") ==
        "An assertion failed (/x/sphere.cpp:12: Assertion `t > 0' failed.)");
    CHECK(sentence("mine\n").empty());
}

// The parts of a stage: their cases, and their hints.

namespace {

/// The parts that the suites of a stage name in their tags: [part NAME].
std::set<std::string> parts_of(int stage) {
    static const std::regex tag(R"(\[part ([^\]]*)\])");
    const std::string name(stage_name(stage));
    std::set<std::string> parts;
    const std::filesystem::path suites = project_folder / "tests/suites";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(suites)) {
        const std::string file = entry.path().lexically_relative(suites).string();
        if (file.rfind(name, 0) != 0 || entry.path().extension() != ".cpp") continue;
        const std::string text = read_text(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it)
            parts.insert(it->str(1));
    }
    return parts;
}

}  // namespace

TEST_CASE("each part of each stage has hints of its own") {
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        const std::set<std::string> parts = parts_of(stage);
        INFO(stage_name(stage));
        CHECK(parts.size() >= 2);
        for (const std::string& part : parts)
            for (int level = 1; level <= hint_levels; ++level) {
                INFO(part << ", hint " << level);
                const std::string whole = hint_text(stage, level);
                const bool is_about_all = hint_text(stage, level, part) == whole;
                CHECK(is_about_all == (part == "together"));
            }
    }
}

TEST_CASE("the hint of a part is about its functions alone") {
    const std::string frames = hint_text(13, 2, "frames (to_object_space)");
    CHECK(frames.rfind("to_object_space: ", 0) == 0);
    CHECK(frames.find("overlap:") == std::string::npos);
    CHECK(frames.find("intersect with a mesh:") == std::string::npos);
    const std::string both = hint_text(3, 3, "intersect and normal");
    CHECK(both.find("\nnormal:") != std::string::npos);
    CHECK(both.find("color_from_normal") == std::string::npos);
    CHECK(hint_text(3, 1, "") == hint_text(3, 1));
}

TEST_CASE("a case belongs to the last part that the report names") {
    const std::vector<CaseResult> cases = read_report(
        "case a\npart normal\npassed\ncase b\npassed\ncase c\npart torch\npoints 2\nfailed\n");
    REQUIRE(cases.size() == 3);
    CHECK(cases[0].part == "normal");
    CHECK(cases[1].part == "normal");
    CHECK(cases[2].part == "torch");
    CHECK(cases[2].points == 2);
}
