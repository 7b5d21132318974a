// What the student has written, and how far it is: steps/stepNN_name/student/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// What is remembered of a stage, in student/progress.txt, for the student to read.
struct Record {
    std::string checked;  ///< when: "2026-11-21 14:03"; empty if never
    int passed = 0;       ///< cases
    int cases = 0;
    std::string checked_files;  ///< fingerprint of what was checked
    int hints = 0;              ///< that were shown
    int solution_asked = 0;     ///< how often
};

enum class State { untouched, started, done };

/// A stage as the student has it.
class Workbook {
public:
    explicit Workbook(int stage);

    [[nodiscard]] int stage() const { return stage_; }
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    [[nodiscard]] State state() const;
    /// One line about it: "17 of 21 cases pass, 2 hints".
    [[nodiscard]] std::string summary() const;
    /// Changes whenever a file does.
    [[nodiscard]] std::string fingerprint() const;

    [[nodiscard]] const Record& record() const { return record_; }
    /// Remembers, from now on.
    void remember(const Record& record);

    /// Copies the starter. Throws InputError if there are files already.
    void start();
    /// Moves what is there to a folder of its own beside it, which it returns
    /// ("steps/…/student_1"), and starts anew.
    std::string reset();

private:
    /// The starter in a folder of the workshop, whole before anything else is touched.
    [[nodiscard]] std::filesystem::path fresh_start(const std::filesystem::path& workshop) const;

    int stage_;
    std::filesystem::path folder_;
    Record record_;
};

/// The stage that somebody is at: the first that he has started and not done, else the first that
/// is untouched; the last if all are done.
[[nodiscard]] int current_stage();

}  // namespace rt
