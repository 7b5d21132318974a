#include "common/course/build/suite_report.hpp"

#include "common/system/files.hpp"

#include <cstdlib>

namespace rt {

namespace {

/// The rest of the line after the word, if the line starts with it.
bool starts_with(const std::string& line, const std::string& word, std::string& rest) {
    if (line.rfind(word, 0) != 0) return false;
    rest = line.substr(word.size());
    return true;
}

}  // namespace

std::vector<CaseResult> read_report(const std::string& text) {
    std::vector<CaseResult> cases;
    for (const std::string& line : lines_of(text)) {
        std::string rest;
        if (starts_with(line, "case ", rest))
            cases.push_back({.name = rest, .part = cases.empty() ? "" : cases.back().part});
        if (cases.empty()) continue;
        CaseResult& last = cases.back();
        if (starts_with(line, "part ", rest)) last.part = rest;
        if (starts_with(line, "points ", rest)) last.points = std::atoi(rest.c_str());
        if (starts_with(line, "at ", rest)) last.place = rest;
        if (starts_with(line, "| ", rest)) last.failure += rest + "\n";
        if (starts_with(line, "failures ", rest)) last.failures = rest;
        if (line == "passed") last.passed = true;
    }
    return cases;
}

int cases_in_suite(const std::string& report) {
    std::string count;
    return starts_with(report, "cases ", count) ? std::atoi(count.c_str()) : 0;
}

}  // namespace rt
