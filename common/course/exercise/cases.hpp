// The cases of a stage's suites, in the parts in which a student writes the stage.
#pragma once

#include "common/course/build/suite_report.hpp"

#include <set>
#include <string>
#include <vector>

namespace rt {

/// A case in both precisions.
struct Outcome {
    CaseResult in_double;
    CaseResult in_float;

    [[nodiscard]] bool passed() const { return in_double.passed && in_float.passed; }
    [[nodiscard]] const std::string& part() const {
        return in_double.part.empty() ? in_float.part : in_double.part;
    }
};

/// Prints every case below the line of its part. The cases in `given` pass unwritten.
void show_cases(const std::vector<Outcome>& all, const std::set<std::string>& given);

}  // namespace rt
