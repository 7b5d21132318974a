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

/// Prints one line for each part, and the cases of the first part that is not right. The cases in
/// `given` pass unwritten.
void show_cases(const std::vector<Outcome>& all, const std::set<std::string>& given);

/// The first part that is not right; empty if all are right.
[[nodiscard]] std::string first_wrong_part(const std::vector<Outcome>& all);

}  // namespace rt
