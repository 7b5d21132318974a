// One submission while it is graded.
#pragma once

#include "common/course/grade/judging/ask_suite.hpp"
#include "common/course/grade/judging/intake.hpp"
#include "common/system/files.hpp"

#include <map>

namespace rt::grade {

/// A submission on the table.
class SubmissionJob {
public:
    SubmissionJob(const Grading& grading, const Submission& submission);

    [[nodiscard]] const std::string& student() const { return student_; }
    [[nodiscard]] bool has(int stage) const { return handed_in_.files.count(stage) == 1; }
    [[nodiscard]] const std::string& text(int stage) const { return handed_in_.files.at(stage); }

    [[nodiscard]] std::string words(int stage) const;

    /// The hash of the student's files up to a stage.
    [[nodiscard]] std::string chain(int stage) const;

    /// The hash of everything that decides the mark of a stage; `reference` is that of its
    /// reference's.
    [[nodiscard]] std::string key(int stage, const std::string& reference) const;

    /// Compiled once.
    const Build& compiled(int stage);

    /// The worker of the student's stage, among the references.
    Build link(int stage);

    /// The worker of the student's own stages up to this one.
    Build link_chain(int stage, std::chrono::steady_clock::time_point until);

    [[nodiscard]] std::filesystem::path worker() const { return scratch_.path() / "worker"; }

    /// In the results, beside the mark.
    [[nodiscard]] std::filesystem::path beside(int stage, const std::string& ending) const;

private:
    [[nodiscard]] std::filesystem::path object(int stage) const;

    Build link(int stage, const std::map<int, std::filesystem::path>& objects);

    const Grading& grading_;
    std::string student_;
    SubmittedFiles handed_in_;
    TemporaryFolder scratch_;
    std::map<int, Build> compiled_;
    /// The stage and the objects of worker().
    std::pair<int, std::map<int, std::filesystem::path>> linked_;
};

}  // namespace rt::grade
