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
};

/// Runs one of the project's programs with an untrusted worker, which the launcher seals. Throws
/// Interrupted.
[[nodiscard]] ProcessResult run_asking(const Grading& grading, int stage, const Command& program,
                                       const Command& variables,
                                       std::chrono::steady_clock::time_point until);

/// The report of a file's suite on the worker, run with these additional variables. Contains the
/// cases that were reached.
[[nodiscard]] std::vector<CaseMark> ask_suite(const Grading& grading, GradedFile graded,
                                              const std::filesystem::path& worker,
                                              std::chrono::steady_clock::time_point until,
                                              const Command& more_variables = {});

}  // namespace rt::grade
