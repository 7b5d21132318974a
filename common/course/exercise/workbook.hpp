// The student's files and progress: steps/stepNN_name/student/.
#pragma once

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// The stored progress of a stage, in student/progress.txt, which the student may read.
struct Record {
    std::string checked;  ///< the time of the last check: "2026-11-21 14:03"; empty if never
                          ///< checked
    int passed = 0;       ///< number of cases
    int cases = 0;
    std::string checked_files;  ///< fingerprint of the checked files
    std::string part;           ///< the first part that was not right
    int hints = 0;              ///< number of hints shown, of all parts
    std::string hint_part;      ///< the part of the last hint
    int hint_level = 0;         ///< the highest that was shown for this part
    int solution_asked = 0;     ///< number of times that the solution was shown
};

enum class State { untouched, started, done };

/// A stage with the student's files.
class Workbook {
public:
    explicit Workbook(int stage);

    [[nodiscard]] int stage() const { return stage_; }
    [[nodiscard]] std::vector<fs::path> files() const;
    [[nodiscard]] State state() const;
    /// True if trace_file is among the files.
    [[nodiscard]] bool has_trace() const;
    /// The last check: "17 of 21 cases pass", "changed since it passed", "changed since 17 of 21
    /// cases passed"; empty if not started.
    [[nodiscard]] std::string verdict() const;
    /// The same with the number of hints.
    [[nodiscard]] std::string summary() const;
    /// Changes whenever a file does.
    [[nodiscard]] std::string fingerprint() const;

    [[nodiscard]] const Record& record() const { return record_; }
    /// Stores the progress.
    void remember(const Record& record);

    /// Copies the starter. A trace_file goes on from the student's own of the stage before, if
    /// there is one, under the starter's first comment. Throws InputError if files exist already.
    void start();
    /// Moves the student's files to a new folder beside it, which it returns ("steps/…/student_1"),
    /// and copies the starter.
    std::string reset();

private:
    /// A complete copy of the starter in the workshop, made before anything else is touched.
    [[nodiscard]] fs::path fresh_start(const fs::path& workshop) const;

    int stage_;
    fs::path folder_;
    Record record_;
};

/// The error of a command that needs a file of the student's.
[[nodiscard]] InputError not_started(int stage);

/// The student's current stage: the first that is started and not done, else the first that is not
/// started; the last if all are done.
[[nodiscard]] int current_stage();

/// The stage after this one, if this copy of the project has it: a hand-out may leave it out.
[[nodiscard]] std::optional<int> next_stage(int stage);

/// The other stages with files of the student's that a program of this stage can use.
[[nodiscard]] std::vector<int> started_before(int stage);

}  // namespace rt
