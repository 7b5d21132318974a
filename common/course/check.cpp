#include "common/course/check.hpp"

#include "common/course/build.hpp"
#include "common/course/compiler_errors.hpp"
#include "common/course/diagnosis.hpp"
#include "common/course/files.hpp"
#include "common/course/paint.hpp"
#include "common/course/pictures.hpp"
#include "common/course/process.hpp"
#include "common/course/project.hpp"
#include "common/course/suite.hpp"
#include "common/course/workbook.hpp"
#include "common/input_error.hpp"
#include "common/png.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <future>
#include <set>
#include <thread>

namespace rt {

namespace {

constexpr std::chrono::seconds picture_limit{20};

/// A case in both precisions.
struct Outcome {
    CaseResult in_double;
    CaseResult in_float;

    [[nodiscard]] bool passed() const { return in_double.passed && in_float.passed; }
};

/// Both suites' cases, in the order of the suite. One that a crash has kept from being asked has
/// not passed.
std::vector<Outcome> outcomes(const SuiteResult& in_double, const SuiteResult& in_float) {
    std::vector<Outcome> all;
    const auto& most =
        in_double.cases.size() >= in_float.cases.size() ? in_double.cases : in_float.cases;
    const auto at = [](const SuiteResult& suite, std::size_t i, const std::string& name) {
        return i < suite.cases.size() ? suite.cases[i] : CaseResult{.name = name};
    };
    for (std::size_t i = 0; i < most.size(); ++i)
        all.push_back({at(in_double, i, most[i].name), at(in_float, i, most[i].name)});
    return all;
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    char text[] = "2026-11-21 14:03";
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", std::localtime(&time));
    return text;
}

/// What the student's code printed, each line once: it may print for every ray.
void show_output(const SuiteResult& suite) {
    constexpr std::size_t most = 12;
    std::set<std::string> seen;
    for (const std::string& line : lines_of(suite.output)) {
        if (!seen.insert(line).second) continue;
        if (seen.size() > most) {
            std::puts("  …");
            break;
        }
        std::printf("  %s\n", line.c_str());
    }
    if (!seen.empty()) std::puts("");
}

void explain_failure(const Outcome& first, const SuiteResult& in_double,
                     const SuiteResult& in_float) {
    const bool float_only = first.in_double.passed;
    const CaseResult& failed = float_only ? first.in_float : first.in_double;
    const SuiteResult& suite = float_only ? in_float : in_double;
    std::printf("\n%s%s\n", painted(failed.name, Paint::bold).c_str(),
                float_only ? "  (in float only)" : "");
    for (const std::string& line : lines_of(failed.failure)) std::printf("    %s\n", line.c_str());
    if (!failed.place.empty()) std::printf("    asked:    %s\n", failed.place.c_str());
    if (!suite.ended.empty() && failed.name == suite.cases.back().name)
        std::printf("    your code %s\n    The cases after this one were not asked.\n",
                    suite.ended.c_str());
}

/// My picture beside the stage's, in a file that is told.
void show_picture(int stage) {
    const std::string name(stage_name(stage));
    const std::filesystem::path mine = build_folder / (name + "_mine.png");
    const Ending ending =
        listen_to({(build_folder / (name + "_judged")).string(), "--quiet", "-o", mine.string()},
                  picture_limit);
    if (ending.out_of_time || ending.status != 0) {
        std::printf("\nno picture: the program %s\n",
                    ending.out_of_time             ? "has no end"
                    : crash(ending.status).empty() ? ending.output.c_str()
                                                   : ("crashed: " + crash(ending.status)).c_str());
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

void show_cases(const std::vector<Outcome>& all) {
    for (const Outcome& outcome : all)
        std::printf("%s\n", outcome.passed()
                                ? painted("  ✓ " + outcome.in_double.name, Paint::dim).c_str()
                                : painted("  ✗ " + outcome.in_double.name, Paint::bad).c_str());
}

}  // namespace

int check(int stage) {
    Workbook workbook(stage);
    const std::string name(stage_name(stage));
    if (workbook.files().empty())
        throw InputError({}, name + " is not started: ./course start " + std::to_string(stage));
    choose_reference("");
    const Build built = try_build({name + "_test_double", name + "_test_float", name + "_judged"});
    if (!built.succeeded) {
        std::fputs(first_error(built.output).c_str(), stdout);
        return 1;
    }
    const std::string files = workbook.fingerprint();
    std::future<SuiteResult> beside =
        std::async(std::launch::async, [&name] { return run_suite(name + "_test_float"); });
    const SuiteResult in_double = run_suite(name + "_test_double");
    const SuiteResult in_float = beside.get();

    const std::vector<Outcome> all = outcomes(in_double, in_float);
    const auto passed = std::count_if(all.begin(), all.end(),
                                      [](const Outcome& outcome) { return outcome.passed(); });
    const bool ended = in_double.ended.empty() && in_float.ended.empty();
    const bool right = ended && !all.empty() && passed == std::ptrdiff_t(all.size());
    Record record = workbook.record();
    record.checked = now();
    record.passed = int(passed);
    record.cases = int(all.size()) + (ended ? 0 : 1);
    record.checked_files = files;
    workbook.remember(record);

    show_output(in_double);
    show_cases(all);
    std::fputs(first_warning(built.output).c_str(), stdout);
    const auto first = std::find_if(all.begin(), all.end(),
                                    [](const Outcome& outcome) { return !outcome.passed(); });
    if (first != all.end()) explain_failure(*first, in_double, in_float);
    if (ended) show_picture(stage);
    const bool written = in_double.output.find("is not written yet") == std::string::npos;
    if (ended && !right && written) show_diagnosis(stage);
    const std::string count = std::to_string(passed) + " of " + std::to_string(all.size()) +
                              " cases pass, in float and double";
    std::printf("\n%s: %s\n", painted(name, Paint::bold).c_str(),
                painted(count, right ? Paint::good : Paint::bad).c_str());
    if (right && stage < int(stage_names.size()))
        std::printf("Next: ./course start %d\n", stage + 1);
    if (!right) std::printf("Stuck? ./course hint %d\n", stage);
    return right ? 0 : 1;
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
        std::printf("\nwaiting for %s to be saved; Ctrl-C ends\n",
                    step_path(stage, "student").c_str());
        std::fflush(stdout);
    }
}

}  // namespace rt
