// Known mistakes as changes of right answers.
#include "common/course/authoring/mistake_source.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include "tests/kit/catch.hpp"

#include <regex>

using namespace rt;
namespace fs = std::filesystem;

namespace {

const std::string head =
    "mistake far in reference\norigin: invented\ncaught by: a case\nsentence: You take the far "
    "one.\n";

/// A project with one right answer and one catalogue.
class Project {
public:
    explicit Project(const std::string& catalogue) {
        write("steps/step03_sphere/reference/sphere.cpp",
              "#include <cmath>\n\nnamespace rt {\n\nReal near() {\n    return 1;\n}\n\n"
              "Real both() {\n    const Real t = near();\n    return t + nearest(t);\n}\n\n"
              "}  // namespace rt\n");
        write("tests/alternatives/step03_sphere.cpp",
              "// right other: twice as far\n#define near(...) correct_near(__VA_ARGS__)\n"
              "#include \"steps/step03_sphere/reference/sphere.cpp\"\n#undef near\n\n"
              "namespace rt {\n\nReal near() {\n    return 2;\n}\n\n}  // namespace rt\n");
        write("tests/mistakes/step03_sphere.txt", catalogue);
    }

    /// The source of the first mistake, or the error.
    [[nodiscard]] std::string source() const {
        try {
            return source_of(folder_.path(), "step03_sphere",
                             read_known_mistakes(folder_.path(), "step03_sphere").at(0));
        } catch (const InputError& error) {
            return error.what();
        }
    }

private:
    void write(const std::string& file, const std::string& text) {
        fs::create_directories((folder_.path() / file).parent_path());
        write_text(folder_.path() / file, text);
    }

    TemporaryFolder folder_;
};

std::string source(const std::string& catalogue) {
    return Project(catalogue).source();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a mistake is its right answer with other lines") {
    const std::string far = source(head +
                                   "-    return 1;\n+    return 2;\n\n"
                                   "     const Real t = near();\n+    // twice\n");
    CHECK(contains(far, "Real near() {\n    return 2;\n}\n"));
    CHECK(contains(far, "    const Real t = near();\n    // twice\n    return t + nearest(t);\n"));
    CHECK_FALSE(contains(far, "return 1"));
}

TEST_CASE("a function that a mistake calls around has another name, where it is called, too") {
    std::string around = head;
    around.replace(around.find("reference"), 9, "reference around near");
    const std::string text = source(around + "+Real near() {\n+    return -correct_near();\n+}\n");
    CHECK(contains(text, "Real correct_near() {\n    return 1;\n"));
    CHECK(contains(text, "const Real t = correct_near();\n    return t + nearest(t);\n"));
    CHECK(contains(text, "Real near() {\n    return -correct_near();\n}\n\n}  // namespace rt\n"));
}

TEST_CASE("a right answer that includes another one is one source") {
    std::string other = head;
    other.replace(other.find("reference"), 9, "other");
    const std::string text = source(other + "-    return 2;\n+    return 3;\n");
    CHECK(text.starts_with("#include <cmath>\n"));
    CHECK_FALSE(contains(text, "reference"));
    CHECK(contains(text, "Real correct_near() {\n    return 1;\n"));
    CHECK(contains(text, "const Real t = correct_near();"));
    CHECK(contains(text, "Real near() {\n    return 3;\n"));
}

TEST_CASE("lines that are not in the right answer, or twice, are an error with their place") {
    const std::string place = "tests/mistakes/step03_sphere.txt:5: error: these lines are ";
    const std::string file = "steps/step03_sphere/reference/sphere.cpp";
    CHECK(source(head + "-    return 7;\n+    return 2;\n") == place + "not in " + file);
    CHECK(source(head + "-}\n+};\n") == place + "in " + file + " twice: add some");
    CHECK(source(head + "-    return 1;\n+    return 2;\n\n-    return 1;\n-}\n") ==
          "tests/mistakes/step03_sphere.txt:8: error: these lines change twice");
}

TEST_CASE("a catalogue that is not complete is an error with its place") {
    const std::string change = "-    return 1;\n+    return 2;\n";
    const auto error = [](int line, const std::string& what) {
        return "tests/mistakes/step03_sphere.txt:" + std::to_string(line) + ": error: " + what;
    };
    CHECK(source("mistake far in reference\norigin: invented\n" + change) ==
          error(4, "far ends here without its origin, caught by or sentence"));
    CHECK(source(head) == error(4, "far ends here without a change"));
    CHECK(source(head + change + "\n" + head + change) == error(8, "far is there twice"));
    CHECK(source("mistake far in textbook\n") ==
          error(1, "tests/alternatives/step03_sphere.cpp has no answer textbook"));
    CHECK(source("mistake far\n") == error(1, "expected \"mistake NAME in RIGHT_ANSWER\""));
    CHECK(contains(source(head + "return 1;\n"), "step03_sphere.txt:5: error: expected "));
}

TEST_CASE("sentences are in plain words, without the names of the code") {
    const std::regex of_code(
        R"(\b[a-z]{2,}_[a-z]{2,}|::|[a-z]\.[a-z]|\b(?!tan\()[a-z]{2,}\(|\w\[|\b[A-Z][a-z]+[A-Z][a-z]|\bReal\b)");
    CHECK(std::regex_search("Take surface.error.", of_code));
    CHECK(std::regex_search("Turn it with face_forward.", of_code));
    for (const std::string_view stage : stage_names)
        for (const char* of_trace : {"", "_trace"})
            for (const KnownMistake& mistake :
                 read_known_mistakes(RAYSTEPS_ROOT, std::string(stage) + of_trace)) {
                INFO(stage << of_trace << ": " << mistake.name << ": " << mistake.sentence);
                CHECK_FALSE(std::regex_search(mistake.sentence, of_code));
            }
}

TEST_CASE("every known mistake is a change of a right answer that is there") {
    std::size_t count = 0;
    for (const std::string_view stage : stage_names)
        for (const char* of_trace : {"", "_trace"}) {
            const std::string suite = std::string(stage) + of_trace;
            for (const KnownMistake& mistake : read_known_mistakes(RAYSTEPS_ROOT, suite)) {
                INFO(suite << ": " << mistake.name);
                ++count;
                CHECK(contains(source_of(RAYSTEPS_ROOT, suite, mistake), "namespace rt {"));
            }
        }
    CHECK(count >= 600);
}
