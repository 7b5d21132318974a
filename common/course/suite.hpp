// A stage's suite, run, and what came of each case.
#pragma once

#include "common/course/report.hpp"

namespace rt {

struct SuiteResult {
    std::vector<CaseResult> cases;
    std::string ended;   ///< why it came to no end: it crashed or took too long; else empty
    std::string output;  ///< what the student's own code printed
};

/// Runs a suite's program, for ten seconds at most.
[[nodiscard]] SuiteResult run_suite(const std::string& program);

}  // namespace rt
