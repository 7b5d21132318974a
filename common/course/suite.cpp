#include "common/course/suite.hpp"

#include "common/course/files.hpp"
#include "common/course/process.hpp"
#include "common/course/project.hpp"

namespace rt {

namespace {

constexpr std::chrono::seconds time_limit{10};  // the slowest suite takes one

/// What follows the word, if the line starts with it.
bool starts_with(const std::string& line, const std::string& word, std::string& rest) {
    if (line.rfind(word, 0) != 0) return false;
    rest = line.substr(word.size());
    return true;
}

}  // namespace

SuiteResult run_suite(const std::string& program) {
    const std::filesystem::path report = build_folder / (program + ".report");
    std::filesystem::remove(report);
    const Ending ending = listen_to({"env", "RAYSTEPS_REPORT=" + report.string(),
                                     (build_folder / program).string(), "--out", "/dev/null"},
                                    time_limit);
    SuiteResult result{.output = ending.output};
    if (std::filesystem::exists(report)) result.cases = read_report(read_text(report));
    if (ending.out_of_time)
        result.ended =
            "has no end: it was stopped after " + std::to_string(time_limit.count()) + " s";
    else if (!ending.crash.empty())
        result.ended = "crashed: " + ending.crash;
    return result;
}

std::vector<CaseResult> read_report(const std::string& text) {
    std::vector<CaseResult> cases;
    for (const std::string& line : lines_of(text)) {
        std::string rest;
        if (starts_with(line, "case ", rest)) cases.push_back({.name = rest});
        if (cases.empty()) continue;
        CaseResult& last = cases.back();
        if (starts_with(line, "at ", rest)) last.place = rest;
        if (starts_with(line, "| ", rest)) last.failure += rest + "\n";
        if (line == "passed") last.passed = true;
    }
    return cases;
}

}  // namespace rt
