// The parts of a stage: their cases, and their hints.
#include "common/course/build/project.hpp"
#include "common/course/build/suite_report.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <regex>
#include <set>

using namespace rt;

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
