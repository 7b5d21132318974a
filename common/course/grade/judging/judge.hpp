// The grading of one submission.
#pragma once

#include "common/course/grade/judging/ask_suite.hpp"
#include "common/course/grade/judging/intake.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/system/files.hpp"

#include <map>
#include <mutex>

namespace rt::grade {

/// The reference's result: the points of each case of a stage.
struct ReferenceResult {
    fs::path worker;              ///< built from the references alone
    std::string key;              ///< hash of everything that decides a mark, apart from the
                                  ///< student's files
    std::vector<CaseMark> cases;  ///< of the functions, then of `trace`; all of them pass
};

/// Compiles the reference of a stage as a submission. Throws ProgramError if it does not compile:
/// then no submission would, for a reason of this machine.
void compile_reference(const Grading& grading, int stage);

/// Grades the reference of a stage, and leaves its worker in the folder. Throws ProgramError if it
/// does not get all points: then no submission could.
[[nodiscard]] ReferenceResult judge_reference(const Grading& grading, int stage,
                                              const fs::path& folder);

class SubmissionJob;

/// Grades submissions, on several threads.
class Judge {
public:
    Judge(const Grading& grading, std::map<int, ReferenceResult> reference_results)
        : grading_(grading), yardsticks_(std::move(reference_results)) {}

    /// Writes a mark for each stage, unless an up-to-date mark exists. If the grader itself fails
    /// at some of them, postpones these: the next run judges them again. Returns the first reason,
    /// or an empty text. Throws Interrupted when the workshop is stopped.
    [[nodiscard]] std::string judge(const Submission& submission);

private:
    void judge(SubmissionJob& job, int stage);
    void postpone(const std::string& student, int stage);
    [[nodiscard]] Mark mark(SubmissionJob& job, int stage);
    void mark_file(SubmissionJob& job, GradedFile graded, Mark& mark);
    [[nodiscard]] std::optional<PictureMark> picture(SubmissionJob& job, int stage);

    const Grading& grading_;
    const std::map<int, ReferenceResult> yardsticks_;
    std::mutex mutex_;
    // The results of identical files in this run, with the first student who submitted them.
    std::map<std::string, Mark> known_;                                 ///< by stage and file
    std::map<std::string, std::pair<std::string, PictureMark>> drawn_;  ///< by the files of the
                                                                        ///< chain of stages
};

}  // namespace rt::grade
