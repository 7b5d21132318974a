// Known mistakes as changes of right answers.
#include "common/course/authoring/known_mistakes.hpp"

#include "common/course/exercise/trace_mistakes.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>
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
              "// right other around near: twice as far\n"
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

TEST_CASE("a right answer around a function of the reference is one source with it") {
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

// The names of known mistakes of `trace`, by everything that they fail.

namespace {

/// Digests of failures.
const std::string red_for_blue = "0000000100aa";
const std::string black = "0000000200bb";
const std::string white = "0000000200cc";  // the same question, another answer

/// The failures of six other questions.
const std::string six =
    "000000110011 000000120011 000000130011 000000140011 000000150011 000000160011";

/// Three mistakes: the second also fails what the first fails, in the same way.
const std::string known =
    "# A comment.\n"
    "mistake farthest: You keep the farthest hit: t is compared the wrong way round.\n" +
    red_for_blue + "\nmistake first_hit: You return the first hit.\n" + red_for_blue + " " + black +
    "\nmistake no_torch: No torch.\n" + six + " " + black + "\n";

CaseResult passes(const std::string& name) {
    return {.name = name, .passed = true};
}

CaseResult fails(const std::string& name, const std::string& digest) {
    return {.name = name, .failures = digest};
}

/// The names and sentences of the mistakes, or nothing.
std::string recognized(const std::vector<CaseResult>& cases, const std::string& file = known) {
    const TemporaryFolder folder(std::filesystem::temp_directory_path());
    const std::filesystem::path path = folder.path() / "trace.txt";
    write_text(path, file);
    std::string names;
    for (const TraceMistake& each : recognized_trace_mistakes(path, cases))
        names += (names.empty() ? "" : "; ") + each.name +
                 (each.is_certain ? ": " : " probably: ") + each.sentence;
    return names;
}

const std::string farthest =
    "farthest: You keep the farthest hit: t is compared the wrong way round.";
const std::string first_hit = "first_hit: You return the first hit.";
const std::string closest = "the closest is seen (M1)";
const std::string behind = "a sphere behind the eye is not seen";

}  // namespace

TEST_CASE("a mistake of trace has its name if the same cases fail in the same way") {
    CHECK(recognized({fails(closest, red_for_blue), passes(behind)}) == farthest);
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, black)}) == first_hit);
    CHECK(recognized({fails(behind, black), fails(closest, red_for_blue)}) == first_hit);
}

TEST_CASE("a trace that fails fewer cases, more cases or others has no known mistake's name") {
    CHECK(recognized({passes(closest), passes(behind)}).empty());
    CHECK(recognized({}).empty());
    CHECK(recognized({passes(closest), fails(behind, black)}).empty());
    CHECK(recognized({fails(closest, red_for_blue), fails("another", "0000000300dd")}).empty());
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, black),
                      fails("another", "0000000300dd")})
              .empty());
}

TEST_CASE("a trace that fails the questions of a known mistake with other answers has no name") {
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, white)}).empty());
    CHECK(recognized({fails(closest, "0000000100ab")}).empty());
}

TEST_CASE("a mistake is probable if it fails nearly the same questions, and one side no others") {
    const std::string probable = "no_torch probably: No torch.";
    CHECK(recognized({fails(closest, six)}) == probable);
    CHECK(recognized({fails(closest, six), fails(behind, black)}) == "no_torch: No torch.");
    CHECK(recognized({fails(closest, six), fails(behind, black + " " + red_for_blue)}) == probable);
    CHECK(recognized({fails(closest, six), fails(behind, white)}).empty());
    CHECK(recognized({fails(closest, six.substr(0, 38))}).empty());
}

TEST_CASE("two mistakes are recognized together where each explains its part") {
    const std::string both = "000000030033 000000040044";
    const std::string one = "000000110011 000000120011 000000130011 " + both;
    const std::string other = "000000210022 000000220022 000000230022 " + both;
    const std::string two = "mistake one: One.\n" + one + "\nmistake other: Other.\n" + other;
    const std::string names = "one probably: One.; other probably: Other.";
    CHECK(recognized({fails(closest, one + " " + other)}, two) == names);
    // A question that both fail gets the answer of both mistakes at once, which can be the right
    // one.
    const std::string alone = one.substr(0, 38) + " " + other.substr(0, 38);
    CHECK(recognized({fails(closest, alone + " 000000030077")}, two) == names);
    CHECK(recognized({fails(closest, alone)}, two) == names);
    // A failure of neither, one of another answer, and too little of the second.
    CHECK(recognized({fails(closest, alone + " 000000990099")}, two).empty());
    CHECK(recognized({fails(closest, alone + " 000000210023")}, two).empty());
    CHECK(recognized({fails(closest, alone.substr(0, 64))}, two).empty());
    // A third one explains as much as the second.
    CHECK(recognized({fails(closest, alone)}, two + "\nmistake third: Third.\n" + other).empty());
    CHECK(recognized({fails(closest, alone)}, two + "\nmistake third: Other.\n" + other) == names);
}

TEST_CASE("the picture, which depends on everything, does not count for the name of a mistake") {
    const CaseResult picture = fails("the picture of the stage, by this trace (CR §2.1)", black);
    CHECK(recognized({fails(closest, red_for_blue), picture}) == farthest);
    CHECK(recognized({passes(closest), picture}).empty());
}

TEST_CASE("a stage without known mistakes of trace names none") {
    const std::vector<CaseResult> cases = {fails(closest, red_for_blue)};
    CHECK(recognized(cases, "").empty());
    CHECK(recognized(cases, "# A comment.\n").empty());
    CHECK(recognized_trace_mistakes("no/such/trace.txt", cases).empty());
}
