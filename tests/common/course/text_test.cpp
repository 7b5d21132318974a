// Texts that `./course` prints: suggestions, long lines, errors of the linker.
#include "common/course/build/compiler_errors.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/terminal.hpp"
#include "common/system/wrap.hpp"

#include "tests/kit/catch.hpp"

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
        " in steps/step07_cylinder/student/cylinder.cpp and steps/step03_sphere/student/sphere.cpp";
    const std::string cure =
        "\nPut helper functions into an anonymous namespace: namespace { … }\n";
    CHECK(first_error("mold: error: duplicate symbol: " + b + ": " + a + ": rt::solve(float)\n") ==
          "error: defined twice: rt::solve(float)" + both + cure);
    CHECK(first_error("/usr/bin/ld: " + b + ": in function `rt::solve(float)':\n" +
                      "cylinder.cpp:(.text+0x0): multiple definition of `rt::solve(float)'; " + a +
                      ":sphere.cpp:(.text+0x0): first defined here\n")
              .rfind("error: defined twice: rt::solve(float)", 0) == 0);
    CHECK(first_error("mold: error: duplicate symbol: main.cpp.o: " + a + ": main\n") ==
          "error: defined twice: main in steps/step03_sphere/student/sphere.cpp\n"
          "The program has a main of its own: remove yours.\n");
}
