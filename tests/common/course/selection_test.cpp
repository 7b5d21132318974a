// The files of a hand-out, and what a lecturer leaves out of them.
#include "common/course/handout/selection.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;

TEST_CASE("a hand-out may have a part of the stages, whose programs all stay") {
    Selection selection;
    CHECK(is_selected(selection, "docs/step13_meshes.md"));
    select_stages(selection, "2-8");
    for (const char* path :
         {"docs/step01_ray_generation.md", "docs/step09_phong.md", "steps/step13_meshes/hints.md",
          "steps/step10_shadows/starter/main.cpp"}) {
        INFO(path);
        CHECK_FALSE(is_selected(selection, path));
    }
    for (const char* path : {"docs/step02_camera_basis.md", "steps/step08_cone/hints.md",
                             "steps/step03_sphere/starter/sphere.cpp", "docs/errata.md",
                             "steps/step13_meshes/main.cpp", "steps/step09_phong/phong.hpp",
                             "scenes/step09_phong.rt", "docs/gallery/step09_phong.png"}) {
        INFO(path);
        CHECK(is_selected(selection, path));
    }
    select_stages(selection, "5");
    CHECK(selection.stages == std::set{5});
    select_stages(selection, "1-3,9,mirror");
    CHECK(selection.stages == std::set{1, 2, 3, 9, 12});
    for (const char* wrong :
         {"", "8-1", "0-3", "1-99", "1-", "-3", "1-8-9", "a", "1..8", "1-3,", "3,99"}) {
        INFO(wrong);
        CHECK_THROWS_AS(select_stages(selection, wrong), InputError);
    }
}

TEST_CASE("a hand-out may have a part of the hints, and no answers") {
    const std::string hints = "# Hints\n\n## 1\n\nA.\n\n## 2\n\nB.\n\n## 3\n\nC.\n";
    const std::string file = "steps/step03_sphere/hints.md";
    const auto with = [&](int levels) { return selected_text({.hints = levels}, file, hints); };
    CHECK(with(3) == hints);
    CHECK(with(2) == "# Hints\n\n## 1\n\nA.\n\n## 2\n\nB.\n");
    CHECK(with(1) == "# Hints\n\n## 1\n\nA.\n");
    CHECK(with(0) == "# Hints\n");
    const std::string page =
        "## Questions\n\n1. Why?\n\n<details><summary>Answers</summary>\n\n1. So.\n\n</details>\n"
        "\n<details><summary>For the curious</summary>\n\nMore.\n\n</details>\n";
    const std::string docs = "docs/step03_sphere.md";
    CHECK(selected_text({}, docs, page) == page);
    CHECK(selected_text({.answers = false}, docs, page) ==
          "## Questions\n\n1. Why?\n\n<details><summary>For the curious</summary>\n\nMore.\n\n"
          "</details>\n");
    CHECK(selected_text({.hints = 0}, docs, page) == page);
}

TEST_CASE("translations have no more than the page") {
    const std::string header = "msgid \"\"\nmsgstr \"\"\n\"Language: fr\\n\"\n";
    const std::string item =
        "#, no-wrap\nmsgid \"\"\n\"An item\\n\"\n\"of \\\"two\\\" lines.\\n\"\nmsgstr \"Deux "
        "lignes.\\n\"\n";
    const std::string answer = "#. type: Plain text\nmsgid \"So.\"\nmsgstr \"Parce que.\"\n";
    const std::string all = header + "\n" + item + "\n" + answer;
    CHECK(selected_entries(all, "- An item\n  of \"two\" lines.\n\n1. So.\n") == all);
    CHECK(selected_entries(all, "- An item\n  of \"two\" lines.\n") == header + "\n" + item);
    CHECK(selected_entries(all, "Nothing.\n") == header);
    CHECK(selected_entries(header + "\n#~ msgid \"So.\"\n#~ msgstr \"Parce que.\"\n", "So.\n") ==
          header);
}

// Tests that a hand-out has no solution, and that nothing is missing from it.

namespace fs = std::filesystem;

namespace {

/// The files of the project's folders, by their paths.
std::vector<std::string> files() {
    std::vector<std::string> paths;
    for (const char* folder : {"common", "docs", "lang", "scenes", "steps", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(RAYSTEPS_ROOT) / folder))
            if (entry.is_regular_file())
                paths.push_back(entry.path().lexically_relative(RAYSTEPS_ROOT).string());
    return paths;
}

/// The number of matching files. No student may get any of them.
int kept_back(const std::string& pattern) {
    int count = 0;
    for (const std::string& path : files()) {
        if (!std::regex_match(path, std::regex(pattern))) continue;
        ++count;
        INFO(path);
        CHECK_FALSE(is_for_students(path));
    }
    return count;
}

}  // namespace

TEST_CASE("a hand-out has no solution") {
    CHECK(kept_back(R"(steps/step\w*/reference/.*)") >= 13);
    CHECK(kept_back(R"(steps/step\w*/story\.cpp|common/explain/\w*_parts\.cpp)") >= 10);
    CHECK(kept_back(R"(steps/step\w*/exact/.*|common/exact/.*)") >= 13);
    CHECK(kept_back(R"(tests/mistakes/[^/]*)") >= 25);
    CHECK(kept_back(R"(tests/alternatives/.*)") >= 20);
    CHECK(kept_back(R"(tests/(mutation|oracle|stability|measurements)/.*)") >= 50);
    CHECK(kept_back(R"(docs/.*\.[ch]pp)") >= 20);
}

TEST_CASE("a hand-out has no student's work, whoever committed it") {
    for (const char* file :
         {"sphere.cpp", "main.cpp", "helpers.hpp", "tests/mine.cpp", "notes.md", "progress.txt"})
        for (const char* folder : {"student/", "student_1/"}) {
            const std::string path = std::string("steps/step03_sphere/") + folder + file;
            INFO(path);
            CHECK_FALSE(is_for_students(path));
        }
}

TEST_CASE("a hand-out has nothing that grades") {
    CHECK(kept_back("common/course/grade/.*") >= 40);
    CHECK(kept_back("tests/grading/.*") >= 30);
    CHECK(kept_back("tests/contract/.*") >= 25);
}

TEST_CASE("whatever a file of a hand-out includes is in it") {
    const std::regex include(R"re(^#include "([^"]+)"$)re");
    int count = 0;
    for (const std::string& path : files()) {
        if (!is_for_students(path) || !std::regex_search(path, std::regex(R"(\.[ch]pp$)")))
            continue;
        std::istringstream lines(read_text(fs::path(RAYSTEPS_ROOT) / path));
        for (std::string line; std::getline(lines, line);) {
            std::smatch included;
            if (!std::regex_match(line, included, include)) continue;
            if (included[1].str().rfind("common/exact/", 0) == 0) continue;  // #ifdef RT_EXACT
            ++count;
            INFO(path << " includes " << included[1]);
            CHECK(is_for_students(included[1]));
            CHECK(fs::exists(fs::path(RAYSTEPS_ROOT) / included[1].str()));
        }
    }
    CHECK(count > 500);
}

// Pages of a hand-out, which leaves out files that the project's pages lead to.

TEST_CASE("a link to a file that a hand-out leaves out becomes its text") {
    const TemporaryFolder project;
    const std::filesystem::path docs = project.path() / "docs";
    std::filesystem::create_directories(docs / "pictures");
    write_text(project.path() / "README.md", "");
    write_text(docs / "pictures/a.png", "");
    CHECK(with_live_links("[a](../tests/a.cpp), [b](../README.md), [`c`](pictures/c.md#d).\n"
                          "![picture](pictures/a.png)",
                          docs) == "a, [b](../README.md), `c`.\n![picture](pictures/a.png)");
    const std::string kept =
        "[a](https://host/x/y), [b](#place), [&](const Real& a / b), x[i](y), ](a/b) [a](b/c";
    CHECK(with_live_links(kept, docs) == kept);
}
