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
    [[nodiscard]] bool has(GradedFile file) const { return handed_in_.files.count(file) == 1; }
    [[nodiscard]] const std::string& text(GradedFile file) const {
        return handed_in_.files.at(file);
    }
    /// The SHA-256 of a file; empty if it was not handed in.
    [[nodiscard]] std::string source(GradedFile file) const;

    [[nodiscard]] std::string words(GradedFile file) const;

    /// The hash of the files that draw the picture of a stage.
    [[nodiscard]] std::string chain(int stage) const;

    /// The hash of everything that decides the mark of a stage; `reference` is that of its
    /// reference's.
    [[nodiscard]] std::string key(int stage, const std::string& reference) const;

    /// Compiled once.
    const Build& compiled(GradedFile file);

    /// The worker of the student's file, among the references.
    Build link(GradedFile file);

    /// The worker of the student's own stages up to this one, and of its `trace`.
    Build link_chain(int stage);

    [[nodiscard]] fs::path worker() const { return scratch_.path() / "worker"; }

    /// In the results, beside the mark.
    [[nodiscard]] fs::path beside(int stage, const std::string& ending) const;

private:
    /// A copy of the project's main.cpp is not the student's.
    void leave_out_ours();
    /// A sentence; empty for a student's own file.
    [[nodiscard]] std::string why_ours(GradedFile file, const std::string& text) const;

    [[nodiscard]] fs::path object(GradedFile file) const;

    Build link(int stage, const std::map<GradedFile, fs::path>& objects);

    const Grading& grading_;
    std::string student_;
    SubmittedFiles handed_in_;
    TemporaryFolder scratch_;
    std::map<GradedFile, Build> compiled_;
    /// The stage and the objects of worker().
    std::pair<int, std::map<GradedFile, fs::path>> linked_;
};

}  // namespace rt::grade
