#include "common/course/handout/for_students.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <string_view>

namespace rt {

namespace {

/// Not exact, which has the stages' formulas in certified arithmetic; no student grades.
constexpr auto rooms = std::to_array<std::string_view>({
    "common",
    "common/bvh",
    "common/cmake",
    "common/contract",
    "common/course",
    "common/course/authoring",
    "common/course/book",
    "common/course/build",
    "common/course/exercise",
    "common/course/handout",
    "common/course/own",
    "common/course/view",
    "common/explain",
    "common/geometry",
    "common/image",
    "common/math",
    "common/mesh_file",
    "common/program",
    "common/render",
    "common/scene",
    "common/scene_file",
    "common/stages",
    "common/system",
    "common/tuning",
});

/// The parts of `explain` that have a document's formulas, as steps/…/story.cpp.
constexpr std::string_view solved = "common/explain/pixel_log_parts.cpp";

/// The files of the other folders. Left out are tests/mistakes and tests/alternatives, which
/// include references; tests/mutation, which quotes them; tests/oracle, tests/stability,
/// steps/…/exact and story.cpp, which contain their formulas; and tests/contract, by which the
/// grader's suites query a submission.
const std::regex of_other_folders(  //
    R"((README(\.\w\w)?\.md|LICENSE|course|CMakeLists\.txt|CMakePresets\.json|\.clang-format|\.gitignore)"
    R"(|\.gitattributes|\.devcontainer/devcontainer\.json|\.vscode/(launch|tasks)\.json)"
    R"(|docs/.*\.(md|svg|png|js))"
    R"(|lang/(?!\w+/grading\.po).*\.(po|py|txt))"
    R"(|scenes/.*\.(rt|obj|off|ply|stl))"
    R"(|steps/[^/]*|steps/step\w*/((?!story\.)[^/]*|starter/.*))"
    R"(|tests/(CMakeLists\.txt|suites/.*|kit/.*|programs/pictures/[^/]*\.png))"
    R"(|tests/mistakes/\w*/(probes|trace)\.txt))");

}  // namespace

bool is_for_students(const std::string& path) {
    if (path.find("/.") != std::string::npos) return false;
    const std::string folder = std::filesystem::path(path).parent_path().string();
    if (std::find(rooms.begin(), rooms.end(), folder) != rooms.end()) return path != solved;
    return std::regex_match(path, of_other_folders);
}

}  // namespace rt
