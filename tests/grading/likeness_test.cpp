// Files that are alike, and files that only answer the same question.
#include "common/course/grade/results/likeness.hpp"
#include "common/course/authoring/known_mistakes.hpp"
#include "common/course/grade/results/winnowing.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"

#include "tests/grading/reports_class.hpp"
#include "tests/kit/catch.hpp"

#include <algorithm>
#include <random>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

const fs::path project = RAYSTEPS_ROOT;

struct Class : Results {
    void hand_in(const std::string& student, int stage, const std::string& text,
                 const std::string& source = "") {
        const std::string name(stage_name(stage).substr(7));
        write_mark(folder, {.student = student,
                            .stage = stage,
                            .verdict = Verdict::judged,
                            .source = source.empty() ? student : source});
        fs::create_directories(student_folder(folder, student) / "submitted");
        write_text(student_folder(folder, student) / "submitted" / (name + ".cpp"), text);
    }

    void hand_in_trace(const std::string& student, const std::string& text) {
        write_mark(
            folder,
            {.student = student, .stage = 10, .verdict = Verdict::judged, .trace_source = student});
        fs::create_directories(student_folder(folder, student) / "submitted");
        write_text(student_folder(folder, student) / "submitted/shadows_main.cpp", text);
    }

    [[nodiscard]] Similarity found() const {
        return similarity(folder, project, read_marks(folder));
    }
};

std::string text_of(const std::string& file) {
    return read_text(project / file);
}

std::string right_answer(const std::string& suite, const std::string& name) {
    return find_right_answer(project, suite, name).value().text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at))
        text.replace(at, what.size(), with), at += with.size();
    return text;
}

/// Tokens that no other file contains.
std::string noise(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::string tokens;
    for (int i = 0; i < count; ++i) tokens += "+-*%<>=&|^!?;,()"[random() % 16];
    return tokens;
}

}  // namespace

TEST_CASE("names, numbers, comments and layout are nothing to a file's tokens") {
    CHECK(normalized("#include <cmath>\nReal f(Real a) { return a * 2.5; }  // half") ==
          "nn(nn)n*0;");
    CHECK(normalized("const double g_1(double  β)\n{ /* a\nb */ return\tβ*1'000; }") ==
          "nn(nn)n*0;");
    CHECK(normalized("std::sqrt(x)") == normalized("sqrt(x)"));
    CHECK(normalized("if (a) { b(\"}//\\\"\"); } else c('\"');") == "I(n)n(t);En(t);");
    CHECK(normalized("if (not a and b[i]) <% c(); %>") == "I(!n&&n[n])n;");
    CHECK(normalized("/* no end") == "");
    CHECK(normalized("\"no end") == "t");
    CHECK(normalized("\\") == "\\");
    CHECK(normalized("# a \\\n b\nc") == "n");
}

TEST_CASE("macros, spliced lines and lambdas around an answer leave its tokens") {
    const std::string answer = "const Real x = a * b; return x + 1;";
    const std::string tokens = "nn=n*n;n+0;";
    CHECK(normalized(answer) == tokens);
    CHECK(normalized("con\\\nst Real x = a * b; ret\\\r\nurn x + 1;") == tokens);
    CHECK(normalized("const auto x = [&] { return a * b; }; return x() + 1;") == tokens);
    CHECK(normalized("const Real x = [=, &a]() { return a * b; }(); return x + 1;") == tokens);
    CHECK(normalized("  #  define CODE \\\n const Real x = a * b; \\\n return x + 1;\n") ==
          "n" + tokens);
    CHECK(normalized("%:define CODE " + answer) == "n" + tokens);
    CHECK(normalized("a # b") == "n#n");  // a directive only at the start of a line
}

TEST_CASE("a file stays near when its code is in a macro, and when each value is a lambda's") {
    const std::string file = right_answer("step03_sphere", "textbook");
    std::string macro = "#include \"steps/step03_sphere/sphere.hpp\"\n#define ALL \\\n";
    for (const std::string& line : lines_of(file))
        if (!line.starts_with("#")) macro += line.substr(0, line.find("//")) + " \\\n";
    std::string lambdas;
    for (const std::string& line : lines_of(file)) {
        const std::size_t start = line.find(" = ");
        const bool is_value = start != std::string::npos && line.ends_with(';');
        lambdas += !is_value ? line
                             : line.substr(0, start) + " = [&] { return" + line.substr(start + 2) +
                                   " }();";
        lambdas += '\n';
    }
    for (const std::string& changed : {macro + "\nALL\n", lambdas}) {
        Class results;
        results.hand_in("anna", 3, file);
        results.hand_in("ben", 3, changed);
        REQUIRE(results.found().near.size() == 1);
    }
}

TEST_CASE("any 23 tokens have a fingerprint of the file in which they stand") {
    const std::string tokens = noise(500, 1);
    const std::vector<std::uint64_t> prints = fingerprints(tokens);
    const std::vector<std::uint64_t> all = passages(tokens);
    CHECK(all.size() == 500 - 15);
    CHECK(prints.size() < all.size() / 3);
    CHECK(std::includes(all.begin(), all.end(), prints.begin(), prints.end()));
    for (std::size_t i = 0; i + 23 <= tokens.size(); ++i) {
        const std::vector<std::uint64_t> part = passages(tokens.substr(i, 23));
        CHECK(std::find_first_of(part.begin(), part.end(), prints.begin(), prints.end()) !=
              part.end());
        CHECK(fingerprints(tokens.substr(i, 23)).size() == 1);
    }
    CHECK(fingerprints(tokens.substr(0, 15)).empty());
}

TEST_CASE("right answers that were written apart are not near") {
    Class results;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        const std::string name(stage_name(stage));
        for (const fs::path& file : files_in(project / "steps" / name / "reference", ".cpp"))
            results.hand_in(file.stem(), stage, read_text(file));
        const std::vector<RightAnswer> others = read_right_answers(project, name);
        REQUIRE(others.size() > 1);
        for (const RightAnswer& other : others) results.hand_in(other.name, stage, other.text);
    }
    const Similarity found = results.found();
    CHECK(found.same.empty());
    for (const NearFiles& each : found.near) UNSCOPED_INFO(each.one << " is near " << each.other);
    CHECK(found.near.empty());
}

TEST_CASE("a file stays near whatever it is renamed to, and with a line here and there") {
    Class results;
    const std::string file = right_answer("step03_sphere", "textbook");
    std::string edited = "// all mine\n" + file;
    for (const auto& [what, with] : {std::pair{"Real", "double"}, {"sphere", "ball"}, {"ray", "r"}})
        edited = replaced(edited, what, with);
    edited = replaced(edited, "return", "const int unused = 0;\n    return");
    results.hand_in("anna", 3, file);
    results.hand_in("ben", 3, edited);
    results.hand_in("carl", 3, right_answer("step03_sphere", "geometric"));
    const Similarity found = results.found();
    CHECK(found.same.empty());
    REQUIRE(found.near.size() == 1);
    CHECK(found.near[0].one == "anna");
    CHECK(found.near[0].other == "ben");
    CHECK(found.near[0].percent.size() == 1);
    CHECK(found.near[0].percent.at(3) >= near_percent);
    CHECK(found.near[0].percent.at(3) < 100);
}

TEST_CASE("files with trace are compared, apart from what the project gives") {
    Class results;
    const std::string given = text_of("steps/step10_shadows/main.cpp");
    results.hand_in_trace("anna", given + noise(80, 1));
    results.hand_in_trace("ben", "// mine\n" + given + noise(80, 1));
    results.hand_in_trace("carl", given);
    results.hand_in_trace("dora", given + "// mine");
    for (const char* name : {"every_light_is_tried", "without_a_log"})
        results.hand_in_trace(name, right_answer("step10_shadows_trace", name));
    const Similarity found = results.found();
    CHECK(found.same.empty());
    REQUIRE(found.near.size() == 1);
    CHECK(found.near[0].one == "anna");
    CHECK(found.near[0].other == "ben");
    CHECK(found.near[0].percent == std::map<GradedFile, int>{{{10, true}, 100}});
}

TEST_CASE("passages of many students count little") {
    Class results;
    const std::string file = right_answer("step03_sphere", "textbook");
    for (unsigned i = 0; i < 10; ++i)
        results.hand_in("student " + std::to_string(i), 3, file + noise(80, i));
    CHECK(results.found().near.empty());
    results.hand_in("student 10", 3, file + noise(80, 9) + " // mine");
    const Similarity found = results.found();
    REQUIRE(found.near.size() == 1);
    CHECK(found.near[0].one == "student 10");  // "1" before "9"
    CHECK(found.near[0].other == "student 9");
    CHECK(found.near[0].percent.at(3) == 100);
}

TEST_CASE("a statement after every line hides no likeness") {
    const std::string file = right_answer("step03_sphere", "textbook");
    for (const std::string filler : {"if (false) std::abs(1.0);", "[[maybe_unused]] int q = 1;"}) {
        Class results;
        results.hand_in("anna", 3, file);
        results.hand_in("ben", 3, replaced(file, ";\n", ";\n    " + filler + "\n"));
        REQUIRE(results.found().near.size() == 1);
    }
}

TEST_CASE("students who are similar in most stages are first") {
    Class results;
    const auto hand_in = [&](const std::string& one, const std::string& other, int stage) {
        const std::string text = noise(200, unsigned(stage) + unsigned(one[0]));
        results.hand_in(one, stage, text);
        results.hand_in(other, stage, text);
    };
    hand_in("anna", "ben", 3);
    hand_in("carl", "dora", 3);
    hand_in("carl", "dora", 4);
    const Similarity found = results.found();
    REQUIRE(found.near.size() == 2);
    CHECK(found.near[0].one == "carl");
    CHECK(found.near[0].percent == std::map<GradedFile, int>{{3, 100}, {4, 100}});
    CHECK(found.near[1].one == "anna");
}

TEST_CASE("pairs that have a student in common are one group, with the range of their files") {
    const std::vector<NearGroup> found = groups({{"anna", "ben", {{3, 90}}},
                                                 {"carl", "dora", {{3, 80}}},
                                                 {"emil", "fred", {{4, 70}}},
                                                 {"ben", "dora", {{3, 60}, {4, 100}}}});
    REQUIRE(found.size() == 2);
    CHECK(found[0].students == std::set<std::string>{"anna", "ben", "carl", "dora"});
    CHECK(found[0].percent ==
          std::map<GradedFile, std::pair<int, int>>{{3, {60, 90}}, {4, {100, 100}}});
    CHECK(found[1].students == std::set<std::string>{"emil", "fred"});
    CHECK(groups({}).empty());
}

TEST_CASE("a copy of the project's main.cpp is one with other comments, names or line ends") {
    for (const int stage : {1, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13}) {
        INFO("stage " << stage);
        const std::string folder = "steps/" + std::string(stage_name(stage));
        const std::string ours = text_of(folder + "/main.cpp");
        const std::string starter = text_of(folder + "/starter/main.cpp");
        const auto is_copy = [&](const std::string& text) {
            return is_copy_of_main(text, ours, starter);
        };
        CHECK(is_copy(ours));
        CHECK(is_copy("// mine\n" + ours));
        for (const std::string end : {"\r\n", "\r"}) CHECK(is_copy(replaced(ours, "\n", end)));
        CHECK(is_copy("\xef\xbb\xbf" + replaced(ours, "\n", "\r\n")));
        CHECK(is_copy(replaced(replaced(ours, "closest", "nearest"), "    ", "\t")));
        std::string without_comments;
        for (const std::string& line : lines_of(ours))
            without_comments += line.substr(0, line.find("//")) + '\n';
        const bool is_a_line = stage >= 4 && stage <= 8;
        CHECK(is_copy(without_comments) == (!is_a_line && stage != 13));
        CHECK_FALSE(is_copy(starter));
        for (const RightAnswer& other :
             read_right_answers(project, std::string(stage_name(stage)) + "_trace"))
            CHECK_FALSE(is_copy(other.text));
    }
    // The starter of stage 5 with the one line that it lacks.
    const std::string starter = text_of("steps/step05_triangle/starter/main.cpp");
    const std::string last = "closest.test(scene.planes);";
    CHECK_FALSE(
        is_copy_of_main(replaced(starter, last, last + "\n    closest.test(scene.triangles);"),
                        text_of("steps/step05_triangle/main.cpp"), starter));
}

TEST_CASE("a main.cpp with a few changes is reported as like the project's own, and is graded") {
    const std::string folder = "steps/step10_shadows";
    const std::string ours = text_of(folder + "/main.cpp");
    const std::string before = "namespace {\n";
    const std::string declared = replaced(
        ours, before, before + "bool blocked(const Scene&, const ShadowRay&, Context&);\n");
    REQUIRE(declared != ours);
    CHECK_FALSE(is_copy_of_main(declared, ours, text_of(folder + "/starter/main.cpp")));
    Class results;
    results.hand_in_trace("anna", declared);
    results.hand_in_trace("ben", right_answer("step10_shadows_trace", "every_light_is_tried"));
    const Similarity found = results.found();
    REQUIRE(found.like_main.size() == 1);
    CHECK(found.like_main[0].student == "anna");
    CHECK(found.like_main[0].percent >= 90);
}

TEST_CASE("students with the same file are reported once, and not for the starter") {
    Class results;
    const std::string file = right_answer("step03_sphere", "textbook");
    const std::string starter = text_of("steps/step03_sphere/starter/sphere.cpp");
    results.hand_in("anna", 3, file, "17");
    results.hand_in("ben", 3, file, "17");
    results.hand_in("carl", 3, starter, "18");
    results.hand_in("dora", 3, starter, "18");
    results.hand_in("emil", 3, "int x;", "19");
    results.hand_in("fred", 3, "", "20");
    const std::string too_short = noise(40, 1);
    results.hand_in("gil", 3, too_short);
    results.hand_in("hal", 3, too_short);
    const Similarity found = results.found();
    REQUIRE(found.same.size() == 1);
    CHECK(found.same[0].file == GradedFile(3));
    CHECK(found.same[0].students == std::vector<std::string>{"anna", "ben"});
    CHECK(found.near.empty());
}

TEST_CASE("a file that is larger than handwritten is not read") {
    Class results;
    const std::string file = right_answer("step03_sphere", "textbook");
    results.hand_in("anna", 3, file);
    results.hand_in("ben", 3, file + std::string(300 * 1024, ' '));
    results.hand_in("carl", 3, "");
    const fs::path link = student_folder(results.folder, "carl") / "submitted" / "sphere.cpp";
    fs::remove(link);
    fs::create_symlink(student_folder(results.folder, "anna") / "submitted" / "sphere.cpp", link);
    results.hand_in("dora", 3, "");
    fs::remove_all(student_folder(results.folder, "dora") / "submitted");
    CHECK(results.found().near.empty());
}

}  // namespace rt::grade
