#include "common/course/exercise/check.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/status_line.hpp"
#include "common/course/build/student_objects.hpp"
#include "common/course/exercise/cases.hpp"
#include "common/course/exercise/diagnosis.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/course/exercise/may_include.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/course/exercise/wrap.hpp"
#include "common/image/png.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/paint.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <future>
#include <thread>

namespace rt {

namespace {

constexpr std::chrono::seconds picture_limit{20};
constexpr const char* not_written = " is not written yet";  // from common/stages/todo.cpp

/// The results of both suites.
struct Judgement {
    SuiteResult in_double;
    SuiteResult in_float;
    std::vector<Outcome> outcomes;  ///< in the order of the suite

    [[nodiscard]] bool ended() const { return in_double.ended.empty() && in_float.ended.empty(); }
    [[nodiscard]] int passed() const {
        return int(std::count_if(outcomes.begin(), outcomes.end(),
                                 [](const Outcome& outcome) { return outcome.passed(); }));
    }
    [[nodiscard]] bool right() const {
        return ended() && !outcomes.empty() && passed() == int(outcomes.size());
    }
    [[nodiscard]] bool written() const {
        return in_double.output.find(not_written) == std::string::npos;
    }
};

/// Runs both suites at the same time. A case that was not reached because of a crash has not
/// passed.
Judgement judge(const std::string& name) {
    const StatusLine status("testing …");
    std::future<SuiteResult> beside =
        std::async(std::launch::async, [&name] { return run_suite(name + "_test_float"); });
    Judgement judgement{.in_double = run_suite(name + "_test_double")};
    judgement.in_float = beside.get();
    const auto& doubles = judgement.in_double.cases;
    const auto& floats = judgement.in_float.cases;
    for (std::size_t i = 0; i < std::max(doubles.size(), floats.size()); ++i) {
        const std::string& asked = i < doubles.size() ? doubles[i].name : floats[i].name;
        judgement.outcomes.push_back({i < doubles.size() ? doubles[i] : CaseResult{.name = asked},
                                      i < floats.size() ? floats[i] : CaseResult{.name = asked}});
    }
    return judgement;
}

/// Adds the cases of `trace`. They are judged with the references' functions, so that no mistake in
/// a function is one of trace.
void judge_trace(const std::string& name, Judgement& judgement) {
    if (!judgement.ended()) return;
    const Judgement of_trace = judge(name + "_trace");
    judgement.in_double.add(of_trace.in_double);
    judgement.in_float.add(of_trace.in_float);
    judgement.outcomes.insert(judgement.outcomes.end(), of_trace.outcomes.begin(),
                              of_trace.outcomes.end());
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
        for (const std::string& line : *list) std::printf("  %s\n", line.c_str());
        std::puts("");
    }
}

/// Explains the first failure, if there is one.
void explain_failure(const Judgement& judgement) {
    const auto& outcomes = judgement.outcomes;
    const auto first = std::find_if(outcomes.begin(), outcomes.end(),
                                    [](const Outcome& outcome) { return !outcome.passed(); });
    if (first == outcomes.end()) return;
    const bool float_only = first->in_double.passed;
    const CaseResult& failed = float_only ? first->in_float : first->in_double;
    const SuiteResult& suite = float_only ? judgement.in_float : judgement.in_double;
    std::printf("\n%s%s\n", styled(failed.name, Style::bold).c_str(),
                float_only ? "  (in float only)" : "");
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

ProcessResult drawn(const std::string& program, const std::filesystem::path& file) {
    const StatusLine status("drawing your picture …");
    return run_captured({(build_folder / program).string(), "--quiet", "-o", file.string()},
                        picture_limit);
}

/// Writes the student's picture beside the reference's to a file, and prints its path.
void show_picture(int stage) {
    const std::string name(stage_name(stage));
    const TemporaryFolder folder(build_folder);
    const std::filesystem::path mine = folder.path() / "mine.png";
    const ProcessResult ending = drawn(name + "_checked", mine);
    if (ending.out_of_time || ending.status != 0) {
        std::printf("\nno picture: the program %s\n", ending.out_of_time ? "does not end"
                                                      : ending.crash.empty()
                                                          ? ending.output.c_str()
                                                          : ("crashed: " + ending.crash).c_str());
        return;
    }
    const Comparison comparison =
        compare(read_png(mine.string()),
                read_png((project_folder / "docs/pictures" / (name + ".png")).string()));
    const std::string file = "renders/" + name + "_compare.png";
    write_png((project_folder / file).string(), comparison.side_by_side, {});
    std::printf("\nYour picture, the reference's and the difference: %s\n  %s\n", file.c_str(),
                summary(comparison).c_str());
}

/// The cases that the starter passes: they say nothing about a file in which something is missing.
std::set<std::string> passed_by_starter(int stage) {
    const std::filesystem::path file = project_folder / step_path(stage, "starter/passes.txt");
    if (!std::filesystem::exists(file)) return {};
    const std::vector<std::string> lines = lines_of(read_text(file));
    return {lines.begin(), lines.end()};
}

/// Warns of includes that work here, and are refused when the file is graded.
void show_refused_includes(const Workbook& workbook) {
    const int stage = workbook.stage();
    for (const std::filesystem::path& file : workbook.files())
        for (const Include& each : file.filename() == trace_file
                                       ? std::vector<Include>()
                                       : refused_includes(project_folder, stage, file))
            std::printf(
                "%s:%d: warning: a graded file may not include %s: docs/%s.md lists the allowed "
                "headers\n",
                step_path(stage, "student/" + file.filename().string()).c_str(), each.line,
                each.header.c_str(), std::string(stage_name(stage)).c_str());
}

/// Warns of each source file that is linked here, but not when the stage is graded.
void show_ungraded_files(const Workbook& workbook) {
    const int stage = workbook.stage();
    const std::string graded = stage_header(stage).stem().string() + ".cpp";
    for (const std::filesystem::path& file : workbook.files())
        if (file.filename() != graded && file.filename() != trace_file)
            std::printf("%s: warning: only %s is graded: move what it needs of this file into it\n",
                        step_path(stage, "student/" + file.filename().string()).c_str(),
                        graded.c_str());
}

/// Prints the compiler's first warning, also if it was compiled before, with its cure.
void show_warning(int stage) {
    const std::string warning = first_warning(kept_warnings(stage));
    std::fputs(warning.c_str(), stdout);
    if (warning.find("no previous ") != std::string::npos)
        std::puts("Put helper functions into an anonymous namespace: namespace { … }");
}

/// Warns of symbols for which no program can be linked with another stage of the student's.
void show_shared_symbols(int stage) {
    for (const SharedSymbol& each : shared_symbols(stage))
        std::printf(
            "%s: warning: %s is defined twice, also in %s: ./course run cannot link both.\nPut "
            "helper "
            "functions into an anonymous namespace: namespace { … }\n",
            each.file.c_str(), each.name.c_str(), each.other_file.c_str());
}

void remember(const Judgement& judgement, const std::string& files, Workbook& workbook) {
    Record record = workbook.record();
    record.checked = now();
    record.passed = judgement.passed();
    record.cases = int(judgement.outcomes.size()) + (judgement.ended() ? 0 : 1);
    record.checked_files = files;
    record.part = first_wrong_part(judgement.outcomes);
    workbook.remember(record);
}

void show_count(const Judgement& judgement, int stage) {
    const std::string count = std::to_string(judgement.passed()) + " of " +
                              std::to_string(judgement.outcomes.size()) +
                              " cases pass, in float and double";
    std::printf("\n%s: %s\n", styled(std::string(stage_name(stage)), Style::bold).c_str(),
                styled(count, judgement.right() ? Style::good : Style::bad).c_str());
    const std::string part = first_wrong_part(judgement.outcomes);
    if (!judgement.right())
        std::printf("%sStuck? ./course hint %d\n",
                    part.empty() ? "" : ("Write next: " + part + ". ").c_str(), stage);
    else if (stage < int(stage_names.size()))
        std::printf("Next: ./course start %d\n", stage + 1);
}

}  // namespace

int check(int stage) {
    Workbook workbook(stage);
    const std::string name(stage_name(stage));
    if (workbook.files().empty())
        throw InputError({}, name + " is not started: ./course start " + std::to_string(stage));
    choose_reference("");
    std::vector<std::string> targets = {name + "_test_double", name + "_test_float",
                                        name + "_checked"};
    if (workbook.has_trace())
        targets.insert(targets.end(), {name + "_trace_test_double", name + "_trace_test_float"});
    const Build built = try_build(targets);
    if (!built.succeeded) {
        std::fputs(first_error(built.output).c_str(), stdout);
        return 1;
    }
    const std::string files = workbook.fingerprint();
    Judgement judgement = judge(name);
    const bool functions_are_wrong = !judgement.right() && judgement.written();
    if (workbook.has_trace()) judge_trace(name, judgement);
    remember(judgement, files, workbook);

    show_output(judgement.in_double);
    show_cases(judgement.outcomes,
               judgement.written() ? std::set<std::string>() : passed_by_starter(stage));
    show_warning(stage);
    show_shared_symbols(stage);
    show_refused_includes(workbook);
    show_ungraded_files(workbook);
    explain_failure(judgement);
    if (judgement.ended()) show_picture(stage);
    if (functions_are_wrong) show_diagnosis(stage, report_of(name + "_test_double"));
    show_references_used(stage);
    show_count(judgement, stage);
    return judgement.right() ? 0 : 1;
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
