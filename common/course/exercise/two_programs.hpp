// The student's program and the reference's, run with the same arguments.
#pragma once

#include "common/course/build/project.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/system/process.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace rt {

/// Two programs of a stage that are run with the same arguments.
struct ComparisonRequest {
    int stage;
    bool all_mine;  ///< use the student's files of all started stages, not only of this one
    std::string references;  ///< of these: "3;5", or "all"
    Command words;           ///< a scene and program options
    bool all = false;        ///< every line of an explanation
};

/// The student's program of the stage.
[[nodiscard]] inline std::string my_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, contest.all_mine ? "" : "_checked");
}

[[nodiscard]] inline std::string reference_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, "_reference_program");
}

/// Builds both. Throws ProgramError.
void build_both(const ComparisonRequest& contest);

/// A program's output. Without a result, throws InputError or ProgramError.
std::string answer(const std::string& program, const ComparisonRequest& contest,
                   const Command& more, std::chrono::milliseconds limit);

inline constexpr std::chrono::milliseconds reference_limit = std::chrono::minutes(10);
inline constexpr std::chrono::milliseconds least_limit =
    std::chrono::seconds(10);              // as for a suite
inline constexpr int slower_at_most = 20;  // than the reference

template <class Result>
struct Both {
    Result mine;
    Result reference;
};

/// Calls `run(program, limit)` for both programs, the reference's first: the student's gets a limit
/// in proportion to the reference's time, so that an endless loop is stopped soon.
template <class Run>
auto run_both(const ComparisonRequest& contest, const Run& run) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    auto reference = run(reference_program(contest), reference_limit);
    const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
    auto mine = run(my_program(contest), std::max(least_limit, slower_at_most * took));
    return Both<decltype(mine)>{std::move(mine), std::move(reference)};
}

/// Draws both pictures and compares them.
[[nodiscard]] Comparison compare_both(const ComparisonRequest& contest);

/// For options with which a program makes no picture.
inline constexpr const char* no_picture =
    to_translate("with these options no picture is made: nothing is compared");

/// The command that explains the same picture.
[[nodiscard]] std::string explain_command(const ComparisonRequest& contest);

/// Reports whose files the student's program consists of.
void show_parts(const ComparisonRequest& contest);

}  // namespace rt
