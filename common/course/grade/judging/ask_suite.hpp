// A program of the project that queries an untrusted worker, and the stage's suite as one.
#pragma once

#include "common/course/grade/judging/workshop.hpp"
#include "common/course/grade/results/results.hpp"

#include <set>

namespace rt::grade {

/// The settings for grading a class.
struct Grading {
    std::filesystem::path project;
    std::filesystem::path build;
    std::filesystem::path results;
    BuildDirectory workshop;
    std::string seed;  ///< its identifier
    std::set<int> stages;
    /// The limit by the clock of a program that queries a worker. A precaution: the program itself
    /// ends a worker much earlier, by the time that it computes or sleeps.
    std::chrono::milliseconds longest_asking = std::chrono::minutes(15);
};

/// Runs one of the project's programs with an untrusted worker, which the launcher seals. The
/// program gets these variables, and none of the lecturer's environment that could change its
/// result. Throws Interrupted, or ProgramError if it has not ended after the longest time and has
/// computed little of it: the machine is at fault, and not the worker.
[[nodiscard]] ProcessResult run_asking(const Grading& grading, int stage, const Command& program,
                                       const Command& variables);

/// The report of a file's suite on the worker, run with these additional variables. Contains the
/// cases that were reached.
[[nodiscard]] std::vector<CaseMark> ask_suite(const Grading& grading, GradedFile graded,
                                              const std::filesystem::path& worker,
                                              const Command& more_variables = {});

}  // namespace rt::grade
