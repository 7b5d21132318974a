#include "common/course/build/suite_report.hpp"

#include "common/system/files.hpp"

#include <cstdlib>

namespace rt {

std::vector<CaseResult> read_report(const std::string& text) {
    std::vector<CaseResult> cases;
    for (const std::string& line : lines_of(text)) {
        if (const auto name = after("case ", line))
            cases.push_back({.name = *name, .part = cases.empty() ? "" : cases.back().part});
        if (cases.empty()) continue;
        CaseResult& last = cases.back();
        if (const auto part = after("part ", line)) last.part = *part;
        if (const auto points = after("points ", line)) last.points = std::atoi(points->c_str());
        if (const auto place = after("at ", line)) last.place = *place;
        if (const auto words = after("| ", line)) last.failure += *words + "\n";
        if (const auto failures = after("failures ", line)) last.failures = *failures;
        if (line == "passed") last.passed = true;
    }
    return cases;
}

std::set<std::string> passed_by_starter(const fs::path& stage) {
    const std::vector<std::string> lines = lines_in(stage / "starter/passes.txt");
    return {lines.begin(), lines.end()};
}

int cases_in_suite(const std::string& report) {
    return std::atoi(after("cases ", report).value_or("0").c_str());
}

}  // namespace rt
