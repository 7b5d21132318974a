#include "common/course/exercise/screen.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/failing_question.hpp"
#include "common/course/exercise/failure_text.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/stages/not_written.hpp"
#include "common/system/files.hpp"
#include "common/system/paint.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace rt {

namespace {

void print(const std::string& line, Style style) {
    std::printf("%s\n", styled(wrapped(line), style).c_str());
}

/// Prints sentences, which go on at the left.
void print_prose(const std::string& line, std::optional<Style> style = std::nullopt) {
    const std::string text = wrapped_prose(line);
    std::printf("%s\n", style ? styled(text, *style).c_str() : text.c_str());
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// The cases that the starter passes: they prove nothing about a file in which something is
/// missing.
std::set<std::string> passed_by_starter(int stage) {
    const std::filesystem::path file = project_folder / step_path(stage, "starter/passes.txt");
    if (!std::filesystem::exists(file)) return {};
    const std::vector<std::string> lines = lines_of(read_text(file));
    return {lines.begin(), lines.end()};
}

/// Prints the output of the student's code, each line once, since code may print for every ray.
void show_prints(const std::string& output, bool complete) {
    const std::size_t most = complete ? 12 : 4;
    std::vector<std::string> prints;
    for (const std::string& line : lines_of(output))
        if (line.find(not_written) == std::string::npos && prints.size() <= most &&
            std::find(prints.begin(), prints.end(), line) == prints.end())
            prints.push_back(line);
    if (prints.empty()) return;
    std::printf("\n%s\n", tr("Your code prints:").c_str());
    if (prints.size() > most) prints.back() = "…";
    for (const std::string& line : prints) std::printf("  %s\n", line.c_str());
}

void show_verdict(int stage, const Judgment& judgment) {
    const Values counts = {{"passed", std::to_string(judgment.passed())},
                           {"cases", std::to_string(judgment.cases())}};
    const std::string passed =
        judgment.in_float ? tr("{passed} of {cases} cases pass, in float and double", counts)
                          : tr("{passed} of {cases} cases pass, in double", counts);
    std::printf("%s: %s\n", styled(name_of(stage), Style::bold).c_str(),
                styled(passed, judgment.right() ? Style::good : Style::bad).c_str());
}

void show_lines(const std::string& failure, bool complete) {
    bool is_paste = false;
    for (const std::string& line : failure_lines(failure, complete)) {
        const bool goes_on = line.starts_with("    ");
        is_paste = line.starts_with("  paste: ") || (is_paste && goes_on);
        const std::string indented = "    " + tr_line(line);
        std::printf("%s\n", (is_paste ? wrapped_code(indented) : wrapped(indented)).c_str());
    }
}

void show_failure(const CaseResult& failed, const SuiteResult& suite, const std::string& remark,
                  bool complete) {
    std::puts("");
    print("✗ " + tr(failed.name) + remark, Style::bad);
    if (!failed.ended.empty()) {  // a failure that came before is of another question
        std::printf("%s\n", wrapped("    " + failed.ended).c_str());
        if (suite.not_reached > 0)
            std::printf("    %s\n", tr("The {number} cases after this one were not run.",
                                       {{"number", std::to_string(suite.not_reached)}})
                                        .c_str());
        return;
    }
    show_lines(failed.failure, complete);
    if (complete && !failed.place.empty())
        std::printf("    %s\n", tr_text("asked:    " + failed.place).c_str());
}

/// Prints the smallest call with a wrong answer, if that is shorter than the failing one.
void show_smallest(const Diagnosis& diagnosis, const CaseResult& failed, bool complete) {
    const bool shorter =
        length_of_call(brief_code(diagnosis.smallest)) < length_of_call(brief_code(failed.failure));
    if (diagnosis.smallest.empty() || !failed.ended.empty() || !(shorter || complete)) return;
    std::printf("\n%s\n", tr("A plainer call with a wrong answer:").c_str());
    show_lines(diagnosis.smallest, complete);
    if (!diagnosis.drawing.empty())
        std::printf("    %s\n", tr_line("  drawn:    " + diagnosis.drawing).c_str());
}

/// Prints how many other cases fail, and whether they call the part that is wrong, too.
void show_others(const Findings& findings, const std::vector<CaseResult>& cases, int stage) {
    const Judgment& judgment = findings.judgment;
    const int others = judgment.cases() - judgment.passed() - 1;
    if (others <= 0 || !judgment.in_double.written() || !judgment.ended()) return;
    const Values values = {{"number", std::to_string(others)}, {"stage", std::to_string(stage)}};
    std::string line = others == 1
                           ? tr("{number} more case fails: ./course check {stage} --all.", values)
                           : tr("{number} more cases fail: ./course check {stage} --all.", values);
    if (!parts_that_use(findings.part, cases, findings.known).empty())
        line += " " + tr("The other failures may have the same cause.");
    print_prose(line, Style::dim);
}

/// The place of the message on an unwritten function: "steps/…/student/sphere.cpp:22".
std::string place_of(const std::string& function, const std::string& output) {
    for (const std::string& line : lines_of(output)) {
        const std::size_t end = line.find(": " + function + not_written);
        if (end != std::string::npos) return line.substr(0, end);
    }
    return "";
}

}  // namespace

Findings findings_of(int stage, Judgment judgment, Diagnosis diagnosis) {
    KnownCases known = known_cases(project_folder / mistakes_folder, name_of(stage));
    const bool in_double = !judgment.in_double.right();
    const SuiteResult& suite =
        in_double || !judgment.in_float ? judgment.in_double.suite : judgment.in_float->suite;
    std::string part = part_to_mend(suite.cases, known);
    return {std::move(judgment), std::move(diagnosis), std::move(known), std::move(part)};
}

void show_result(int stage, const Findings& findings, bool complete) {
    const Judgment& judgment = findings.judgment;
    const bool in_double = !judgment.in_double.right() || !judgment.in_float;
    const Judged& judged = in_double ? judgment.in_double : *judgment.in_float;
    show_verdict(stage, judgment);
    for (const std::string& sentence : findings.diagnosis.sentences)
        print_prose(tr_text(sentence), Style::bold);
    if (complete && !findings.diagnosis.names.empty())
        print_prose(tr("mistake: {names}", {{"names", listed(findings.diagnosis.names)}}));
    const auto& unwritten = judgment.in_double.unwritten;
    if (!unwritten.empty())
        print_prose(tr("Not written yet: {functions}.", {{"functions", listed(unwritten)}}));
    show_prints(judgment.in_double.suite.output, complete);
    if (complete)
        show_cases(judgment.outcomes,
                   unwritten.empty() ? std::set<std::string>() : passed_by_starter(stage));
    const bool is_written = std::none_of(unwritten.begin(), unwritten.end(), [&](const auto& name) {
        return names(findings.part, name);
    });
    const std::vector<CaseResult>& cases = judged.suite.cases;
    const std::size_t first =
        is_written ? most_telling(cases, findings.part, findings.diagnosis.names, findings.known)
                   : first_failing(cases, findings.part);
    if (first == cases.size()) return;
    const CaseResult& failed = cases[first];
    remember_shown_case(stage, failed.name);
    show_failure(failed, judged.suite, in_double ? "" : "  " + tr("(in float only)"), complete);
    if (findings.diagnosis.names.empty() || complete)
        show_smallest(findings.diagnosis, failed, complete);
    show_others(findings, cases, stage);
}

void show_next_step(const Workbook& workbook, const Findings& findings, bool draws) {
    const int stage = workbook.stage();
    const std::string number = std::to_string(stage);
    const Judged& judged = findings.judgment.in_double;
    if (findings.judgment.right() && !draws) {
        std::puts(tr("The cases pass, but not the picture: see above.").c_str());
    } else if (findings.judgment.right()) {
        if (const auto next = next_stage(stage))
            std::puts(tr("Next: ./course {command} {stage}",
                         {{"command", Workbook(*next).files().empty() ? "start" : "check"},
                          {"stage", std::to_string(*next)}})
                          .c_str());
    } else {
        const auto unwritten =
            std::find_if(judged.unwritten.begin(), judged.unwritten.end(),
                         [&](const std::string& name) { return names(findings.part, name); });
        const std::string help = tr("Stuck? ./course hint {stage}", {{"stage", number}});
        if (unwritten != judged.unwritten.end())
            std::printf(
                "%s\n%s\n",
                tr("Write next: {function}, in {place}",
                   {{"function", *unwritten}, {"place", place_of(*unwritten, judged.suite.output)}})
                    .c_str(),
                help.c_str());
        else if (findings.part.empty() || findings.part == "together")
            print_prose(help);
        else
            print_prose(tr("Look at {part}.", {{"part", tr_text(findings.part)}}) + " " + help);
    }
}

}  // namespace rt
