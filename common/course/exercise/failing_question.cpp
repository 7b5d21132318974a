#include "common/course/exercise/failing_question.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"

#include <algorithm>
#include <regex>

namespace rt {

namespace {

/// "--term specular" of "save it to render it, with --term specular and …".
Command options_in(const std::string& line) {
    Command options = words_of(line.substr(std::min(line.find("--"), line.size())));
    options.erase(std::ranges::find(options, "and"), options.end());
    return options;
}

FailingQuestion question_in(const std::string& failure) {
    FailingQuestion question;
    std::string lines;
    bool in_scene = false;
    for (const std::string& line : lines_of(failure)) {
        const std::string words = trimmed(line);
        if (words.starts_with("got:")) break;
        if (!words.starts_with("scene:")) {
            lines += (lines.empty() || in_scene ? "" : " ") + words + (in_scene ? "\n" : "");
            continue;
        }
        static const std::regex place(R"(.*\bpixel (\d+,\d+) of (\d+) x (\d+) .*)");
        std::smatch match;
        question.pixel = "0,0";
        if (std::regex_match(lines, match, place)) {
            question.pixel = match[1].str();
            question.scene = "R " + match[2].str() + " " + match[3].str() + "\n";
        }
        question.options = options_in(words);
        lines.clear();
        in_scene = true;
    }
    static const std::regex call(R"([a-z_]+\(.*\))");
    if (in_scene && question.scene.empty())
        question.scene = lines;
    else if (in_scene)  // in place of the scene's own first line, R 1 1
        question.scene += lines.substr(lines.find('\n') + 1);
    else if (lines.size() < 4000 && std::regex_match(lines, call))
        question.call = lines;
    return question;
}

fs::path file_of_shown_case(int stage) {
    return build_folder / stage_target(stage, "_shown_case.txt");
}

}  // namespace

void remember_shown_case(int stage, const std::string& name) {
    write_text(file_of_shown_case(stage), name);
}

std::string shown_case(int stage) {
    const fs::path file = file_of_shown_case(stage);
    return fs::exists(file) ? read_text(file) : "";
}

std::optional<FailingQuestion> failing_question(std::vector<CaseResult> results,
                                                const std::string& shown) {
    std::ranges::stable_partition(results,
                                  [&shown](const CaseResult& each) { return each.name == shown; });
    for (const CaseResult& each : results) {
        if (each.passed) continue;
        FailingQuestion question = question_in(each.failure);
        question.case_name = each.name;
        if (!question.call.empty() || !question.scene.empty()) return question;
    }
    return std::nullopt;
}

}  // namespace rt
