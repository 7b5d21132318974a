// A stage's suite, run, and what came of each case.
#pragma once

#include <string>
#include <vector>

namespace rt {

struct CaseResult {
    std::string name;
    bool passed = false;
    std::string place;    ///< of its first failure: "tests/step05_triangle_test.cpp:61"
    std::string failure;  ///< what it says, line by line
};

struct SuiteResult {
    std::vector<CaseResult> cases;
    std::string ended;   ///< why it came to no end: it crashed or took too long; else empty
    std::string output;  ///< what the student's own code printed
};

/// Runs a suite's program, for ten seconds at most.
[[nodiscard]] SuiteResult run_suite(const std::string& program);

/// Reads what tests/kit/report.cpp writes.
[[nodiscard]] std::vector<CaseResult> read_report(const std::string& text);

}  // namespace rt
