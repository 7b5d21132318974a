// What a suite tells of its cases.
#pragma once

#include <string>
#include <vector>

namespace rt {

struct CaseResult {
    std::string name;
    int points = 1;  ///< what it is worth
    bool passed = false;
    std::string place;    ///< of its first failure: "tests/step05_triangle_test.cpp:61"
    std::string failure;  ///< what it says, line by line
};

/// Reads what tests/kit/report.cpp writes.
[[nodiscard]] std::vector<CaseResult> read_report(const std::string& text);

}  // namespace rt
