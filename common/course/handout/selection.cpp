#include "common/course/handout/selection.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/stages/stage_list.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/translation.hpp"

#include <regex>
#include <sstream>

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
std::string words_of(const std::string& text) {
    std::istringstream in(text);
    std::string words;
    for (std::string word; in >> word;) words += (words.empty() ? "" : " ") + word;
    return words;
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
    for (const auto& folder : std::filesystem::directory_iterator(project_folder / "lang")) {
        const std::string name = folder.path().filename().string();
        if (!std::filesystem::exists(folder.path() / "book.po")) continue;
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
    const std::string words = words_of(page);
    std::string selected;
    for (const std::string& entry : catalogue_entries(catalogue)) {
        const std::string english = words_of(catalogue_text(entry, "msgid"));
        if (!entry.starts_with("#~") && words.find(english) != std::string::npos)
            selected += (selected.empty() ? "" : "\n") + entry;
    }
    return selected;
}

}  // namespace rt
