// The results of a stage's suites, in each precision, and of their cases, in the parts in which a
// student writes the stage.
#pragma once

#include "common/course/build/suite_report.hpp"
#include "common/course/exercise/suite.hpp"

#include <optional>
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

/// The result of a suite, and of the suite of `trace` after it, in one precision.
struct Judged {
    SuiteResult suite;
    std::vector<std::string> unwritten = {};  ///< the functions that are not written yet
    bool functions_are_wrong = false;         ///< though written; without `trace`
    std::vector<CaseResult> of_trace = {};    ///< the cases of `trace`, if all of them were reached

    [[nodiscard]] int passed() const;
    /// Also the cases that a crash has left out.
    [[nodiscard]] int cases() const { return int(suite.cases.size()) + suite.not_reached; }
    [[nodiscard]] bool right() const;
    [[nodiscard]] bool written() const { return unwritten.empty(); }
};

/// Both precisions. Without `in_float`, double had to be right first.
struct Judgment {
    Judged in_double;
    std::optional<Judged> in_float;
    std::vector<Outcome> outcomes;  ///< in the order of the suite

    /// A case that was not reached because of a crash has not passed.
    Judgment(Judged double_result, std::optional<Judged> float_result);

    [[nodiscard]] bool ended() const;
    [[nodiscard]] int passed() const;
    [[nodiscard]] int cases() const;
    [[nodiscard]] bool right() const;
};

/// The functions that the output reports as not written yet, in its order.
[[nodiscard]] std::vector<std::string> unwritten_in(const std::string& output);

}  // namespace rt
