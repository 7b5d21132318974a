// The report of a suite on its cases.
#pragma once

#include "common/system/files.hpp"

#include <set>
#include <string>
#include <vector>

namespace rt {

struct CaseResult {
    std::string name;
    std::string part;  ///< the part of its stage; empty if the suite has no parts
    int points = 1;    ///< points if it passes
    bool passed = false;
    std::string
        place;  ///< the place of its first failure: "tests/suites/step05_triangle_test.cpp:61"
    std::string failure;   ///< the message of the failure, line by line
    std::string failures;  ///< the digest of all its failures: the questions and the wrong answers
    std::string ended;     ///< the reason, if the suite ended in this case: a crash or a timeout

    /// True if the failure is of a random input.
    [[nodiscard]] bool is_random() const {
        return failure.find("\n  random: ") != std::string::npos;
    }
};

/// Parses the output of tests/kit/report.cpp.
[[nodiscard]] std::vector<CaseResult> read_report(const std::string& text);

/// The cases that the starter in this folder of a stage passes: they prove nothing about a file in
/// which something is missing.
[[nodiscard]] std::set<std::string> passed_by_starter(const fs::path& stage);

/// The number of cases that the suite has, also those that were not reached; 0 if not reported.
[[nodiscard]] int cases_in_suite(const std::string& report);

}  // namespace rt
