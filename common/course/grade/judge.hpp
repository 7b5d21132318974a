// One submission, judged.
#pragma once

#include "common/course/grade/intake.hpp"
#include "common/course/grade/results.hpp"

#include <atomic>
#include <map>
#include <mutex>
#include <set>

namespace rt::grade {

/// Where a class is graded, and by what.
struct Grading {
    std::filesystem::path project;
    std::filesystem::path build;
    std::filesystem::path results;
    Workshop workshop;
    std::string seed;  ///< by its identifier
    std::set<int> stages;
};

/// What judging the references gave: what each stage's cases are worth.
struct Yardstick {
    std::filesystem::path worker;  ///< of the references alone
    std::string key;               ///< of what decides a mark, apart from the student's files
    std::vector<CaseMark> cases;   ///< all passed
    std::chrono::milliseconds took{0};
};

/// Compiles the reference of a stage as if it were handed in. Throws ProgramError if it does not
/// compile: then nothing would, whatever may be wrong with this machine.
void compile_reference(const Grading& grading, int stage);

/// Judges the reference of a stage, whose worker goes to the folder. Throws ProgramError if it has
/// not all the points: then nobody could.
[[nodiscard]] Yardstick judge_reference(const Grading& grading, int stage,
                                        const std::filesystem::path& folder);

/// Judges submissions, on several threads.
class Judge {
public:
    Judge(const Grading& grading, std::map<int, Yardstick> yardsticks)
        : grading_(grading), yardsticks_(std::move(yardsticks)) {}

    /// Writes a mark for each stage, unless there is one already that the same would come of. If it
    /// is we who fail, says why, and the marks that are left say so; the next run judges them
    /// again. Throws Interrupted once the workshop is stopped.
    [[nodiscard]] std::string judge(const Envelope& envelope);

private:
    class Desk;

    using Time = std::chrono::steady_clock::time_point;

    void judge(Desk& desk, int stage);
    // Nobody is asked anything after the time.
    [[nodiscard]] Mark mark(Desk& desk, int stage, Time until);
    [[nodiscard]] std::optional<PictureMark> picture(Desk& desk, int stage, Time until);

    const Grading& grading_;
    const std::map<int, Yardstick> yardsticks_;
    std::mutex mutex_;
    // What came of files alike, in this run, and the student who was first.
    std::map<std::string, Mark> known_;                                 ///< by stage and file
    std::map<std::string, std::pair<std::string, PictureMark>> drawn_;  ///< by the chain's files
};

}  // namespace rt::grade
