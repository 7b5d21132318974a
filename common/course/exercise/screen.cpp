#include "common/course/exercise/screen.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/failing_question.hpp"
#include "common/course/exercise/failure_text.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace rt {

namespace {

/// Sentences, which go on at the left.
std::string prose(const std::string& line, std::optional<Style> style = std::nullopt) {
    const std::string text = wrapped_prose(line);
    return (style ? styled(text, *style) : text) + "\n";
}

/// The output of the student's code, each line once, since code may print for every ray.
std::string prints_text(const std::string& output, bool complete) {
    const std::size_t most = complete ? 12 : 4;
    std::vector<std::string> prints;
    for (const std::string& line : lines_of(output))
        if (line.find(not_written) == std::string::npos && prints.size() <= most &&
            std::ranges::find(prints, line) == prints.end())
            prints.push_back(line);
    if (prints.empty()) return "";
    std::string text = "\n" + tr("Your code prints:") + "\n";
    if (prints.size() > most) prints.back() = "…";
    for (const std::string& line : prints) text += "  " + line + "\n";
    return text;
}

/// A failure on a terminal: the call or the scene, and what follows it.
struct FailureText {
    std::string question;
    std::string answers;

    [[nodiscard]] std::size_t rows() const { return lines_of(question + answers).size(); }
};

FailureText text_of(const std::string& failure, bool complete) {
    FailureText text;
    bool is_paste = false;
    bool is_answered = false;
    for (const std::string& line : failure_lines(failure, complete)) {
        const bool goes_on = line.starts_with("    ");
        is_paste = line.starts_with("  paste: ") || (is_paste && goes_on);
        is_answered = is_answered || starts_answer(line);
        const std::string indented = "    " + tr_line(line);
        (is_answered ? text.answers : text.question) +=
            (is_paste ? wrapped_code(indented) : wrapped(indented)) + "\n";
    }
    return text;
}

FailureText text_of(const CaseResult& failed, const SuiteResult& suite, bool complete) {
    if (failed.ended.empty()) {
        FailureText text = text_of(failed.failure, complete);
        if (complete && !failed.place.empty())
            text.answers += "    " + tr_text("asked:    " + failed.place) + "\n";
        return text;
    }
    // A failure that came before is of another question.
    std::string answer = wrapped("    " + failed.ended) + "\n";
    if (suite.not_reached > 0)
        answer +=
            "    " +
            tr("The {number} cases after this one were not run.", {{"number", suite.not_reached}}) +
            "\n";
    return {.question = "", .answers = answer};
}

/// The smallest call with a wrong answer, if that is shorter than the failing one.
std::string smallest_text(const Diagnosis& diagnosis, const CaseResult& failed, bool complete) {
    const bool shorter =
        length_of_call(brief_code(diagnosis.smallest)) < length_of_call(brief_code(failed.failure));
    if (diagnosis.smallest.empty() || !failed.ended.empty() || !(shorter || complete)) return "";
    const FailureText call = text_of(diagnosis.smallest, complete);
    std::string text =
        "\n" + tr("A plainer call with a wrong answer:") + "\n" + call.question + call.answers;
    if (!diagnosis.drawing.empty())
        text += "    " + tr_line("  drawn:    " + diagnosis.drawing) + "\n";
    return text;
}

/// The line on the other failing cases, which may have the same cause. Empty if there are none.
std::string others_text(const Findings& findings, const std::vector<CaseResult>& cases, int stage) {
    const Judgment& judgment = findings.judgment;
    const int others = judgment.cases() - judgment.passed() - 1;
    if (others <= 0 || !judgment.in_double.written() || !judgment.ended()) return "";
    const Values values = {{"number", others}, {"stage", stage}};
    std::string line = others == 1
                           ? tr("{number} more case fails: ./course check {stage} --all.", values)
                           : tr("{number} more cases fail: ./course check {stage} --all.", values);
    if (!parts_that_use(findings.part, cases, findings.known).empty())
        line += " " + tr("The other failures may have the same cause.");
    return prose(line, Style::dim);
}

/// The place of the message on an unwritten function: "steps/…/student/sphere.cpp:22".
std::string place_of(const std::string& function, const std::string& output) {
    for (const std::string& line : lines_of(output)) {
        const std::size_t end = line.find(": " + function + not_written);
        if (end != std::string::npos) return line.substr(0, end);
    }
    return "";
}

/// The most telling failure, or the first one of a part that is not written; the number of cases if
/// all pass.
std::size_t case_to_show(const Findings& findings, const std::vector<CaseResult>& cases) {
    const auto& unwritten = findings.judgment.in_double.unwritten;
    const bool is_written = std::ranges::none_of(
        unwritten, [&](const auto& name) { return names(findings.part, name); });
    return is_written ? most_telling(cases, findings.part, findings.diagnosis.names, findings.known)
                      : first_failing(cases, findings.part);
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

void show_verdict(int stage, const Judgment& judgment) {
    const Values counts = {{"passed", judgment.passed()}, {"cases", judgment.cases()}};
    const std::string passed =
        judgment.in_float ? tr("{passed} of {cases} cases pass, in float and double", counts)
                          : tr("{passed} of {cases} cases pass, in double", counts);
    print_line(styled(name_of(stage), Style::bold) + ": " +
               styled(passed, judgment.right() ? Style::good : Style::bad));
    std::fflush(stdout);
}

int show_diagnosis(int stage, const Findings& findings, bool complete) {
    const Judgment& judgment = findings.judgment;
    std::string text;
    for (const std::string& sentence : findings.diagnosis.sentences)
        text += prose(tr_text(sentence), Style::bold);
    if (complete && !findings.diagnosis.names.empty())
        text += prose(tr("mistake: {names}", {{"names", joined(findings.diagnosis.names)}}));
    const auto& unwritten = judgment.in_double.unwritten;
    if (!unwritten.empty())
        text += prose(tr("Not written yet: {functions}.", {{"functions", joined(unwritten)}}));
    text += prints_text(judgment.in_double.suite.output, complete);
    print(text);
    if (complete)
        show_cases(judgment.outcomes,
                   unwritten.empty() ? std::set<std::string>()
                                     : passed_by_starter(project_folder / step_path(stage, "")));
    std::fflush(stdout);
    return int(lines_of(text).size());
}

void show_failure(int stage, const Findings& findings, bool complete, int other_rows) {
    const bool in_double = !findings.judgment.in_double.right() || !findings.judgment.in_float;
    const SuiteResult& suite =
        (in_double ? findings.judgment.in_double : *findings.judgment.in_float).suite;
    const std::size_t shown = case_to_show(findings, suite.cases);
    if (shown == suite.cases.size()) return;
    const CaseResult& failed = suite.cases[shown];
    remember_shown_case(stage, failed.name);
    const std::string title =
        wrapped("✗ " + tr(failed.name) + (in_double ? "" : "  " + tr("(in float only)")));
    FailureText failure = text_of(failed, suite, complete);
    const bool has_name = !findings.diagnosis.names.empty();
    std::string smallest =
        has_name && !complete ? "" : smallest_text(findings.diagnosis, failed, complete);
    const std::string others = others_text(findings, suite.cases, stage);
    if (!complete && output_on_terminal()) {
        const int left =
            terminal_rows() - other_rows - int(lines_of("\n" + title + "\n" + others).size());
        if (int(failure.rows() + lines_of(smallest).size()) > left) smallest.clear();
        const int of_question = left - int(lines_of(failure.answers).size());
        failure.question =
            fitted(failure.question, std::size_t(std::max(of_question, 0)),
                   "      … " + tr("whole: ./course check {stage} --all", {{"stage", stage}}));
    }
    print("\n" + styled(title, Style::bad) + "\n" + failure.question + failure.answers + smallest +
          others);
    std::fflush(stdout);
}

void show_next_step(const Workbook& workbook, const Findings& findings, bool draws) {
    const int stage = workbook.stage();
    const Judged& judged = findings.judgment.in_double;
    if (findings.judgment.right() && !draws) {
        print_line(tr("The cases pass, but not the picture: see above."));
    } else if (findings.judgment.right()) {
        if (const auto next = next_stage(stage))
            print_line(tr("Next: ./course {command} {stage}",
                          {{"command", Workbook(*next).files().empty() ? "start" : "check"},
                           {"stage", *next}}));
    } else {
        const auto unwritten = std::ranges::find_if(
            judged.unwritten, [&](const std::string& name) { return names(findings.part, name); });
        const Values values = {{"stage", stage}};
        const std::string line =
            findings.judgment.ended() ? "" : tr("The line: ./course debug {stage}.", values) + " ";
        const std::string help = line + tr("Stuck? ./course hint {stage}", values);
        if (unwritten != judged.unwritten.end())
            print_line(tr("Write next: {function}, in {place}",
                          {{"function", *unwritten},
                           {"place", place_of(*unwritten, judged.suite.output)}}) +
                       "\n" + help);
        else if (findings.part.empty() || findings.part == "together")
            print(prose(help));
        else
            print(prose(tr("Look at {part}.", {{"part", tr_text(findings.part)}}) + " " + help));
    }
}

}  // namespace rt
