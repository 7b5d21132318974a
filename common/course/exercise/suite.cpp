#include "common/course/exercise/suite.hpp"

#include "common/course/build/project.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"

#include <algorithm>

namespace rt {

namespace {

constexpr std::chrono::seconds suite_time_limit{10};  // the slowest suite takes one

/// The usual cause of the signal, as the end of a sentence.
std::string meaning_of(const std::string& crash) {
    if (crash == "Segmentation fault")
        return ". It used memory that is not its own: a null pointer, an index out of range, or a "
               "function that calls itself without end";
    if (crash == "Aborted") return ". An assertion failed, or std::abort was called";
    if (crash == "Floating point exception") return ". A whole number was divided by 0";
    if (crash == "Killed") return ". The system does so when memory runs out";
    return "";
}

}  // namespace

void SuiteResult::add(const SuiteResult& later) {
    cases.insert(cases.end(), later.cases.begin(), later.cases.end());
    if (ended.empty()) ended = later.ended;
    not_reached += later.not_reached;
    output += later.output;
}

std::filesystem::path report_of(const std::string& program) {
    return build_folder / (program + ".report");
}

SuiteResult run_suite(const std::string& program) {
    const std::filesystem::path report = report_of(program);
    std::filesystem::remove(report);
    const ProcessResult ending =
        run_captured({"env", "RAYSTEPS_REPORT=" + report.string(),
                      (build_folder / program).string(), "--out", "/dev/null"},
                     suite_time_limit);
    if (!ending.out_of_time && !ending.crash.empty() && is_stopped(ending.status))
        throw InputError({}, program + " was told to stop before its end (" + ending.crash +
                                 "), which says nothing about your code: check it again");
    SuiteResult result{.output = ending.output};
    if (std::filesystem::exists(report)) {
        const std::string text = read_text(report);
        result.cases = read_report(text);
        result.not_reached = std::max(cases_in_suite(text) - int(result.cases.size()), 0);
    }
    if (ending.out_of_time)
        result.ended =
            "does not end: it was stopped after " + std::to_string(suite_time_limit.count()) + " s";
    else if (!ending.crash.empty())
        result.ended = "crashed: " + ending.crash + meaning_of(ending.crash);
    if (!result.cases.empty()) result.cases.back().ended = result.ended;
    return result;
}

}  // namespace rt
