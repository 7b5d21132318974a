#include "common/course/handout/selection.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>

namespace rt {

namespace {

/// The text before the heading of the first level that is left out.
std::string with_hints(const std::string& text, int levels) {
    if (levels >= hint_levels) return text;
    return text.substr(0, text.find("\n## " + std::to_string(levels + 1) + "\n"));
}

/// The text without its fold of answers.
std::string without_answers(const std::string& text) {
    const std::string start = "<details><summary>Answers</summary>";
    const std::string end = "</details>\n";
    const std::size_t from = text.find(start);
    if (from == std::string::npos) return text;
    const std::size_t to = text.find(end, from);
    if (to == std::string::npos) return text;
    const std::size_t next = text.find_first_not_of('\n', to + end.size());
    return text.substr(0, from) + (next == std::string::npos ? "" : text.substr(next));
}

/// The words of a text with a blank between them: lines of an item are indented in a page.
std::string on_one_line(const std::string& text) {
    return joined(words_of(text), {}, " ");
}

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
constexpr const char* of_other_folders =
    R"((README(\.\w\w)?\.md|LICENSE|course|CMakeLists\.txt|CMakePresets\.json|\.clang-format|\.gitignore)"
    R"(|\.gitattributes|\.devcontainer/devcontainer\.json|\.vscode/(launch|tasks)\.json)"
    R"(|docs/.*\.(md|svg|png|js))"
    R"(|lang/(?!\w+/grading\.po).*\.(po|py|txt))"
    R"(|scenes/.*\.(rt|obj|off|ply|stl))"
    R"(|steps/[^/]*|steps/step\w*/((?!story\.)[^/]*|starter/.*))"
    R"(|tests/(CMakeLists\.txt|suites/.*|kit/.*|programs/pictures/[^/]*\.png))"
    R"(|tests/mistakes/\w*/(probes|trace)\.txt))";

/// True for the path of a missing file, with a folder. Anything else may be code: `[&](int i)`.
bool leads_nowhere(const std::string& address, const fs::path& folder) {
    const std::string file = address.substr(0, address.find('#'));
    return file.find('/') != std::string::npos && file.find("://") == std::string::npos &&
           file.find_first_of(" ,;\n") == std::string::npos && !fs::exists(folder / file);
}

}  // namespace

void select_stages(Selection& selection, const std::string& stages) {
    const auto found = find_stages(stages);
    if (!found)
        throw InputError(
            {}, "handout: --stages: expected stages, such as 1-5,9, not \"" + stages + "\"");
    selection.stages = *found;
}

void select_language(Selection& selection, const std::string& language) {
    std::string known;
    for (const auto& folder : fs::directory_iterator(project_folder / "lang")) {
        const std::string name = folder.path().filename().string();
        if (!fs::exists(folder.path() / "book.po")) continue;
        known += (known.empty() ? "" : ", ") + name;
        if (name == language) selection.language = language;
    }
    if (selection.language.empty())
        throw InputError({}, "handout: --lang: expected a language of the pages (" + known +
                                 "), not \"" + language + "\"");
    const Command question{"sh", "-c", "command -v po4a && command -v python3"};
    if (run_captured(question, std::chrono::seconds(10)).status != 0)
        throw InputError({}, "handout: --lang " + language + " needs po4a: apt-get install po4a");
}

bool is_selected(const Selection& selection, const std::string& path) {
    std::smatch stage;
    const std::regex of_stage(
        R"((?:docs/step(\d\d)_\w+\.md|steps/step(\d\d)_\w+/(?:starter/.*|hints\.md)))");
    if (!std::regex_match(path, stage, of_stage)) return true;
    const int number = std::stoi(stage[1].matched ? stage[1] : stage[2]);
    return selection.stages.empty() || selection.stages.contains(number);
}

std::string selected_text(const Selection& selection, const std::string& path,
                          const std::string& text) {
    if (path.ends_with("/hints.md")) return with_hints(text, selection.hints);
    return selection.answers ? text : without_answers(text);
}

std::string selected_entries(const std::string& catalogue, const std::string& page) {
    const std::string words = on_one_line(page);
    std::string selected;
    for (const CatalogueEntry& entry : catalogue_entries(catalogue))
        if (!entry.lines.starts_with("#~") &&
            words.find(on_one_line(entry.english)) != std::string::npos)
            selected += (selected.empty() ? "" : "\n") + entry.lines;
    return selected;
}

bool is_for_students(const std::string& path) {
    if (path.find("/.") != std::string::npos) return false;
    const std::string folder = fs::path(path).parent_path().string();
    if (std::ranges::find(rooms, folder) != rooms.end()) return path != solved;
    static const std::regex others(of_other_folders);
    return std::regex_match(path, others);
}

std::string with_live_links(const std::string& page, const fs::path& folder) {
    std::string text;
    std::size_t done = 0;
    for (std::size_t middle = page.find("]("); middle != std::string::npos;
         middle = page.find("](", middle + 2)) {
        const std::size_t start = page.substr(0, middle).find_last_of("[]");
        const std::size_t end = page.find(')', middle);
        if (start == std::string::npos || page[start] != '[' || end == std::string::npos) continue;
        if (!leads_nowhere(page.substr(middle + 2, end - middle - 2), folder)) continue;
        text += page.substr(done, start - done) + page.substr(start + 1, middle - start - 1);
        done = end + 1;
    }
    return text + page.substr(done);
}

}  // namespace rt
