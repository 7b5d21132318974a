// Runs a stage's suite and returns the result of each case.
#pragma once

#include "common/course/build/suite_report.hpp"
#include "common/system/files.hpp"

namespace rt {

struct SuiteResult {
    std::vector<CaseResult> cases;
    std::string ended;    ///< the reason for an early end, a crash or a timeout; else empty
    std::string output;   ///< the output of the student's own code
    int not_reached = 0;  ///< cases after the one in which it ended

    /// Adds the result of a suite that was run after this one.
    void add(const SuiteResult& later);
};

/// The report that `run_suite` leaves.
[[nodiscard]] fs::path report_of(const std::string& program);

/// The results that are left of a program that run_suite has run; empty if there are none.
[[nodiscard]] std::vector<CaseResult> last_results(const std::string& program);

/// The sentence for an assertion of the standard library, as g++'s and clang++'s print it, or of
/// the student's own, with its place; empty without one. Its line is taken from the output.
[[nodiscard]] std::string take_assertion(std::string& output);

/// Runs a suite's program, for at most ten seconds.
[[nodiscard]] SuiteResult run_suite(const std::string& program);

}  // namespace rt
