#include "common/course/exercise/check.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/cases.hpp"
#include "common/course/exercise/diagnosis.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/course/exercise/show_picture.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/course/exercise/trace_mistakes.hpp"
#include "common/course/exercise/warnings.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/stages/not_written.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/paint.hpp"
#include "common/system/process.hpp"
#include "common/system/status_line.hpp"
#include "common/system/terminal.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace rt {

namespace {

/// The result of a suite in one precision.
struct Judged {
    SuiteResult suite;
    bool functions_are_wrong = false;       ///< though written; without `trace`
    std::vector<CaseResult> of_trace = {};  ///< the cases of `trace`, if all of them were reached

    [[nodiscard]] int passed() const {
        return int(std::count_if(suite.cases.begin(), suite.cases.end(),
                                 [](const CaseResult& result) { return result.passed; }));
    }
    [[nodiscard]] bool right() const {
        return suite.ended.empty() && !suite.cases.empty() && passed() == int(suite.cases.size());
    }
    [[nodiscard]] bool written() const { return unwritten().empty(); }
    /// The functions that have said that they are not written yet.
    [[nodiscard]] std::set<std::string> unwritten() const {
        std::set<std::string> names;
        for (const std::string& line : lines_of(suite.output)) {
            const std::size_t end = line.find(not_written);
            if (end == std::string::npos) continue;
            const std::size_t start = line.rfind(' ', end == 0 ? 0 : end - 1) + 1;
            names.insert(line.substr(start, end - start));
        }
        return names;
    }
};

/// Builds the suites in both precisions, and the program for the picture. Calls `judge_double` as
/// soon as the suites in double are built, while the rest of the build goes on; the first time, the
/// rest is large, and waits for that. Prints the first error, if there is one.
bool is_built(const Workbook& workbook, const std::function<void()>& judge_double) {
    const std::string name(stage_name(workbook.stage()));
    const std::string in_double = name + "_suites_double";
    const std::string in_float = name + "_suites_float";
    const auto done = [&](const std::string& edge) {
        if (edge == in_double) judge_double();
    };
    std::vector<std::string> targets = {in_double};
    Build built{.succeeded = true};
    if (!std::filesystem::exists(build_folder / (name + "_test_float")))
        built = try_build(std::exchange(targets, {}), done);
    targets.insert(targets.end(), {in_float, name + "_checked"});
    if (built.succeeded) built = try_build(targets, done);
    if (!built.succeeded) std::fputs(first_error(built.output).c_str(), stdout);
    return built.succeeded;
}

/// Returns whether a part with a case that fails is written.
bool is_any_written(const Judged& judged) {
    const std::set<std::string> unwritten = judged.unwritten();
    return std::any_of(
        judged.suite.cases.begin(), judged.suite.cases.end(), [&](const CaseResult& each) {
            return !each.passed && each.part != "together" && unwritten.count(each.part) == 0;
        });
}

/// Runs the suite, and then the suite of `trace`, which is linked to the references' functions, so
/// that no mistake in a function is one of `trace`.
Judged judge(const Workbook& workbook, const std::string& word) {
    const StatusLine status("testing in " + word + " …");
    const std::string name(stage_name(workbook.stage()));
    Judged judged{.suite = run_suite(name + "_test_" + word)};
    judged.functions_are_wrong = !judged.right() && is_any_written(judged);
    if (workbook.has_trace() && judged.suite.ended.empty()) {
        const SuiteResult of_trace = run_suite(name + "_trace_test_" + word);
        judged.suite.add(of_trace);
        if (of_trace.ended.empty()) judged.of_trace = of_trace.cases;
    }
    return judged;
}

/// The results in both precisions.
struct Judgment {
    Judged in_double;
    Judged in_float;
    std::vector<Outcome> outcomes;  ///< in the order of the suite

    [[nodiscard]] bool ended() const {
        return in_double.suite.ended.empty() && in_float.suite.ended.empty();
    }
    [[nodiscard]] int passed() const {
        return int(std::count_if(outcomes.begin(), outcomes.end(),
                                 [](const Outcome& outcome) { return outcome.passed(); }));
    }
    [[nodiscard]] bool right() const {
        return ended() && !outcomes.empty() && passed() == int(outcomes.size());
    }
};

/// A case that was not reached because of a crash has not passed.
Judgment judgment_of(Judged in_double, Judged in_float) {
    const auto& doubles = in_double.suite.cases;
    const auto& floats = in_float.suite.cases;
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < std::max(doubles.size(), floats.size()); ++i) {
        const std::string& asked = i < doubles.size() ? doubles[i].name : floats[i].name;
        outcomes.push_back({i < doubles.size() ? doubles[i] : CaseResult{.name = asked},
                            i < floats.size() ? floats[i] : CaseResult{.name = asked}});
    }
    return {std::move(in_double), std::move(in_float), std::move(outcomes)};
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    char text[] = "2026-11-21 14:03";
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", std::localtime(&time));
    return text;
}

/// Prints the output of the student's code, each line once, since code may print for every ray.
/// The messages about functions that are not written yet are first; what is left, the student's
/// own prints, has a heading.
void show_output(const SuiteResult& suite) {
    constexpr std::size_t most = 12;
    std::vector<std::string> messages;
    std::vector<std::string> prints;
    for (const std::string& line : lines_of(suite.output)) {
        auto& list = line.find(not_written) == std::string::npos ? prints : messages;
        if (list.size() <= most && std::find(list.begin(), list.end(), line) == list.end())
            list.push_back(line);
    }
    for (auto* const list : {&messages, &prints}) {
        if (list->empty()) continue;
        if (list == &prints) std::puts("Your code prints:");
        if (list->size() > most) list->back() = "…";
        for (const std::string& line : *list)
            std::printf("%s\n", (list == &prints ? "  " + line : wrapped("  " + line)).c_str());
        std::puts("");
    }
}

/// Explains a case of the suite that failed.
void explain_failure(const CaseResult& failed, const SuiteResult& suite, const char* remark) {
    std::printf("\n%s%s\n", styled(wrapped(failed.name), Style::bold).c_str(), remark);
    if (!suite.ended.empty() && failed.name == suite.cases.back().name) {
        // A failure that came before is of another question.
        std::printf("    your code %s.\n    The cases after this one were not run.\n",
                    suite.ended.c_str());
        return;
    }
    for (const std::string& line : lines_of(failed.failure))
        std::printf("%s\n", wrapped("    " + line).c_str());
    if (!failed.place.empty()) std::printf("    asked:    %s\n", failed.place.c_str());
}

std::string count(int passed, std::size_t cases, const std::string& words) {
    return std::to_string(passed) + " of " + std::to_string(cases) + " cases pass, in " + words;
}

/// Prints a line that is complete before the next build begins.
void show_count(const Judged& judged, const std::string& word) {
    std::printf("%s\n", styled(count(judged.passed(), judged.suite.cases.size(), word),
                               judged.right() ? Style::dim : Style::bad)
                            .c_str());
}

/// The cases that the starter passes: they prove nothing about a file in which something is
/// missing.
std::set<std::string> passed_by_starter(int stage) {
    const std::filesystem::path file = project_folder / step_path(stage, "starter/passes.txt");
    if (!std::filesystem::exists(file)) return {};
    const std::vector<std::string> lines = lines_of(read_text(file));
    return {lines.begin(), lines.end()};
}

/// Prints the result in double, before anything is built in float.
void show_double(const Judged& judged, int stage) {
    const SuiteResult& suite = judged.suite;
    show_output(suite);
    const std::vector<Outcome> outcomes = judgment_of(judged, judged).outcomes;
    show_cases(outcomes, judged.written() ? std::set<std::string>() : passed_by_starter(stage));
    show_count(judged, "double");
    const auto failed = std::find_if(suite.cases.begin(), suite.cases.end(),
                                     [](const CaseResult& result) { return !result.passed; });
    if (failed != suite.cases.end()) explain_failure(*failed, suite, "");
    std::fflush(stdout);
}

/// Prints the cases that fail in float only, of the first part that has some, and explains the
/// first if none fails in double.
void show_float(const Judgment& judgment) {
    constexpr const char* remark = "  (in float only)";
    const SuiteResult& suite = judgment.in_float.suite;
    show_count(judgment.in_float, "float");
    const CaseResult* first = nullptr;
    for (std::size_t i = 0; i < suite.cases.size(); ++i) {
        const CaseResult& each = suite.cases[i];
        if (each.passed || !judgment.outcomes[i].in_double.passed) continue;
        if (!first) first = &each;
        if (each.part == first->part)
            std::printf("%s%s\n", styled(wrapped("  ✗ " + each.name), Style::bad).c_str(), remark);
    }
    if (first && (judgment.in_double.right() || !suite.ended.empty()))
        explain_failure(*first, suite, remark);
    std::fflush(stdout);
}

/// Prints the known mistake of `trace` with the same failures, if there is one.
void show_trace_mistake(int stage, const Judged& judged) {
    const std::set<std::string> unwritten = judged.unwritten();
    if (unwritten.count("trace") + unwritten.count("render") > 0) return;
    const auto mistake = recognized_trace_mistake(
        project_folder / "tests/mistakes" / stage_name(stage) / "trace.txt", judged.of_trace);
    if (!mistake) return;
    const std::string line = "mistake: " + mistake->name + ": " +
                             (mistake->is_certain ? "" : "Probably: ") + mistake->sentence;
    std::printf("\n%s\n", styled(wrapped(line), Style::bold).c_str());
}

void remember(const Judgment& judgment, const std::string& files, Workbook& workbook) {
    Record record = workbook.record();
    record.checked = now();
    record.passed = judgment.passed();
    record.cases = int(judgment.outcomes.size()) + (judgment.ended() ? 0 : 1);
    record.checked_files = files;
    record.part = first_wrong_part(judgment.outcomes);
    workbook.remember(record);
}

/// Returns whether the part is one to write, not what the others do together.
bool is_written(const std::string& part) {
    return !part.empty() && part != "together";
}

void show_end(const Judgment& judgment, bool draws, int stage) {
    const std::string passed =
        count(judgment.passed(), judgment.outcomes.size(),
              judgment.in_double.suite.ended.empty() ? "float and double" : "double");
    std::printf("\n%s: %s\n", styled(name_of(stage), Style::bold).c_str(),
                styled(passed, judgment.right() ? Style::good : Style::bad).c_str());
    const std::string part = first_wrong_part(judgment.outcomes);
    if (judgment.right() && !draws)
        std::printf("The cases pass, but not the picture: see above.\n");
    else if (!judgment.right())
        std::printf("%sStuck? ./course hint %d\n",
                    is_written(part) ? ("Write next: " + part + ". ").c_str() : "", stage);
    else if (stage < int(stage_names.size()))
        std::printf("Next: ./course %s %d\n",
                    Workbook(stage + 1).files().empty() ? "start" : "check", stage + 1);
}

}  // namespace

int check(int stage) {
    Workbook workbook(stage);
    const std::string name(stage_name(stage));
    if (workbook.files().empty())
        throw InputError({}, name + " is not started: ./course start " + std::to_string(stage));
    choose_reference("");
    const std::string files = workbook.fingerprint();
    Judged in_double;
    const auto judge_double = [&] {
        in_double = judge(workbook, "double");
        show_double(in_double, stage);
    };
    if (!is_built(workbook, judge_double)) return 1;
    // Float would crash too, or take as long.
    Judged in_float = in_double.suite.ended.empty() ? judge(workbook, "float") : in_double;
    const Judgment judgment = judgment_of(std::move(in_double), std::move(in_float));
    remember(judgment, files, workbook);
    if (judgment.in_double.suite.ended.empty()) show_float(judgment);
    show_warnings(workbook);
    const bool draws = judgment.ended() && show_picture(stage);
    if (judgment.in_double.functions_are_wrong || judgment.in_float.functions_are_wrong)
        show_diagnosis(stage, report_of(name + "_test_double"), judgment.in_double.unwritten());
    show_trace_mistake(stage, judgment.in_double);
    show_references_used(stage);
    show_end(judgment, draws, stage);
    return judgment.right() && draws ? 0 : 1;
}

void watch(int stage) {
    using namespace std::chrono_literals;
    std::string last;
    for (;; std::this_thread::sleep_for(100ms)) {
        const std::string saved = Workbook(stage).fingerprint();
        if (saved == last) continue;
        last = saved;
        std::puts("");
        try {
            check(stage);
        } catch (const InputError& error) {
            std::puts(error.what());
        }
        std::printf("\nwaiting for a change of %s; Ctrl-C ends\n",
                    step_path(stage, "student").c_str());
        finish_output();
    }
}

}  // namespace rt
