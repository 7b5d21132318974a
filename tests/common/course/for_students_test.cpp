// Tests that a hand-out has no solution, and that nothing is missing from it.
#include "common/course/handout/for_students.hpp"

#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;

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
