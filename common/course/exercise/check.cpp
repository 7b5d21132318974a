#include "common/course/exercise/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/exercise/diagnosis.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/judgment.hpp"
#include "common/course/exercise/screen.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/course/exercise/trace_mistakes.hpp"
#include "common/course/exercise/warnings.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <future>
#include <utility>
#include <vector>

namespace rt {

namespace {

/// Below the result: the picture, the next step, and a prompt or the keys of `watch`.
constexpr int rows_of_rest = 8;

constexpr int rows_of_verdict = 1;

/// Returns whether a part with a case that fails is written.
bool is_any_written(const Judged& judged) {
    return std::ranges::any_of(judged.suite.cases, [&](const CaseResult& each) {
        return !each.passed && each.part != "together" &&
               std::ranges::none_of(judged.unwritten, [&](const std::string& name) {
                   return names(each.part, name);
               });
    });
}

/// Runs the suite, and then the suite of `trace`, which is linked to the references' functions, so
/// that no mistake in a function is one of `trace`.
Judged judge(const Workbook& workbook, const std::string& word) {
    const std::string name(stage_name(workbook.stage()));
    Judged judged{.suite = run_suite(name + "_test_" + word)};
    judged.unwritten = unwritten_in(judged.suite.output);
    judged.functions_are_wrong = !judged.right() && is_any_written(judged);
    if (workbook.has_trace()) {
        const SuiteResult of_trace = run_suite(name + "_trace_test_" + word);
        judged.suite.add(of_trace);
        judged.unwritten = unwritten_in(judged.suite.output);
        if (of_trace.ended.empty()) judged.of_trace = of_trace.cases;
    }
    return judged;
}

/// A judgment that is under way.
using Pending = std::shared_future<Judged>;

/// Waits for the judgment. Throws what `judge` throws.
const Judged& result(const Pending& pending) {
    const StatusLine status(tr("testing …"));
    return pending.get();
}

/// The judgments in both precisions, each under way since its suites were built.
struct Begun {
    Pending in_double = {};
    Pending in_float = {};   ///< may be none
    std::string error = {};  ///< the build's first one; empty if there is none
};

/// Builds the suites in both precisions, and the program for the picture. The first time, all but
/// the suites in double is large: it waits for a judgment in double, and float for a right answer.
Begun begin_judgments(const Workbook& workbook) {
    const std::string name(stage_name(workbook.stage()));
    const std::string in_double = name + "_suites_double";
    const std::string in_float = name + "_suites_float";
    Begun begun;
    const auto judgment = [&workbook](const char* word) {
        return std::async(std::launch::async, judge, std::cref(workbook), word).share();
    };
    const auto done = [&](const std::string& edge) {
        if (edge == in_double) begun.in_double = judgment("double");
        if (edge == in_float) begun.in_float = judgment("float");
    };
    const bool is_first = !std::filesystem::exists(build_folder / (name + "_test_float"));
    std::vector<std::string> targets = {in_double};
    Build build{.succeeded = true};
    if (is_first) build = try_build(std::exchange(targets, {}), done);
    if (!is_first || (build.succeeded && result(begun.in_double).right()))
        targets.push_back(in_float);
    targets.push_back(name + "_checked");
    if (build.succeeded) build = try_build(targets, done);
    if (!build.succeeded) begun.error = first_error(build.output);
    return begun;
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    char text[] = "2026-11-21 14:03";
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", std::localtime(&time));
    return text;
}

/// The variables of the student's `trace` that keep a value from one ray to the next.
std::string kept_by_trace(int stage) {
    std::string names;
    for (const StaticVariable& each : static_variables(stage, compiled_files()))
        if (each.file.filename() == trace_file) names += (names.empty() ? "" : ", ") + each.name;
    return names;
}

/// Adds the known mistakes of `trace` that have the same failures, if there are any. If `trace`
/// keeps a static variable, only that is reported: the answers then depend on the order of the
/// rays, and identify no mistake.
void add_trace_mistakes(int stage, const Judged& judged, Diagnosis& diagnosis) {
    for (const std::string& name : judged.unwritten)
        if (name == "trace" || name == "render") return;
    const bool fails = !std::ranges::all_of(judged.of_trace, &CaseResult::passed);
    if (const std::string kept = fails ? kept_by_trace(stage) : ""; !kept.empty()) {
        diagnosis.sentences.push_back(
            tr("{names} keeps its value from one ray to the next: your color may depend on the "
               "rays before.",
               {{"names", kept}}));
        return;
    }
    for (const TraceMistake& each : recognized_trace_mistakes(
             project_folder / "tests/mistakes" / stage_name(stage) / "trace.txt",
             judged.of_trace)) {
        diagnosis.sentences.push_back((each.is_certain ? "" : "Probably: ") + each.sentence);
        diagnosis.names.push_back(each.name);
    }
}

void remember(const Findings& findings, const std::string& files, Workbook& workbook) {
    Record record = workbook.record();
    record.checked = now();
    record.passed = findings.judgment.passed();
    record.cases = findings.judgment.cases();
    record.checked_files = files;
    record.part = findings.part;
    workbook.remember(record);
}

/// Both results, once everything is built; without float if double has a crash, which float would
/// have, too.
Judgment awaited(const Begun& begun) {
    const Judged& in_double = result(begun.in_double);
    std::optional<Judged> in_float;
    if (begun.in_float.valid() && in_double.suite.ended.empty()) in_float = result(begun.in_float);
    return {in_double, std::move(in_float)};
}

/// The known mistakes with these results, of functions and of `trace`.
Diagnosis recognized(int stage, const Judgment& judgment) {
    const Judged& in_double = judgment.in_double;
    Diagnosis diagnosis;
    if (in_double.functions_are_wrong ||
        (judgment.in_float && judgment.in_float->functions_are_wrong))
        diagnosis =
            diagnosis_of(stage, report_of(name_of(stage) + "_test_double"), in_double.unwritten);
    add_trace_mistakes(stage, in_double, diagnosis);
    return diagnosis;
}

}  // namespace

int check(int stage, bool complete) {
    Workbook workbook(stage);
    if (workbook.files().empty()) throw not_started(stage);
    read_project_translations(step_path(stage, "sentences"));
    choose_reference("");
    const std::string files = workbook.fingerprint();
    const Begun begun = begin_judgments(workbook);
    if (const std::string& error = begun.error; !error.empty()) {
        if (begun.in_double.valid() && !result(begun.in_double).suite.cases.empty()) {
            const Findings findings =
                findings_of(stage, {result(begun.in_double), std::nullopt}, {});
            show_verdict(stage, findings.judgment);
            const int rows = rows_of_verdict + show_diagnosis(stage, findings, complete);
            show_failure(stage, findings, complete,
                         rows + int(lines_of(wrapped_diagnostic(error)).size()));
        }
        std::fputs(wrapped_diagnostic(error).c_str(), stdout);
        return 1;
    }
    const Judgment judgment = awaited(begun);
    show_verdict(stage, judgment);
    const Findings findings = findings_of(stage, judgment, recognized(stage, judgment));
    remember(findings, files, workbook);
    const int rows = rows_of_verdict + show_diagnosis(stage, findings, complete);
    const std::string below = warnings_of(workbook) + references_used(stage);
    show_failure(stage, findings, complete, rows + int(lines_of(below).size()) + rows_of_rest);
    const bool draws = findings.judgment.ended() && show_picture(stage, !findings.judgment.right());
    std::fputs(below.c_str(), stdout);
    show_next_step(workbook, findings, draws);
    return findings.judgment.right() && draws ? 0 : 1;
}

}  // namespace rt
