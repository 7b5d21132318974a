#include "common/course/exercise/suite.hpp"

#include "common/course/build/project.hpp"

#include "common/system/files.hpp"
#include "common/system/process.hpp"

namespace rt {

namespace {

constexpr std::chrono::seconds time_limit{10};  // the slowest suite takes one

}  // namespace

SuiteResult run_suite(const std::string& program) {
    const std::filesystem::path report = build_folder / (program + ".report");
    std::filesystem::remove(report);
    const ProcessResult ending =
        run_captured({"env", "RAYSTEPS_REPORT=" + report.string(),
                      (build_folder / program).string(), "--out", "/dev/null"},
                     time_limit);
    SuiteResult result{.output = ending.output};
    if (std::filesystem::exists(report)) result.cases = read_report(read_text(report));
    if (ending.out_of_time)
        result.ended =
            "does not end: it was stopped after " + std::to_string(time_limit.count()) + " s";
    else if (!ending.crash.empty())
        result.ended = "crashed: " + ending.crash;
    return result;
}

}  // namespace rt
